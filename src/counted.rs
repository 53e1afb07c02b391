//! Sentences about a number of things, as gettext's `ngettext` has them for two forms.

/// The sentence for `count` things: the first format for one of them, the other for none or several. Arguments are of both.
macro_rules! counted {
    ($count:expr, $one:literal, $several:literal $(, $argument:expr)* $(,)?) => {
        if $count == 1 { format!($one $(, $argument)*) } else { format!($several $(, $argument)*) }
    };
}

pub(crate) use counted;
