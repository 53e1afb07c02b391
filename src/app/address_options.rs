//! What the page's address asks for besides the session, such as `?embed&lock=outline,view&theme=light`.
//!
//! | option | meaning |
//! |---|---|
//! | `embed` | no bars and no panels: the two pictures alone |
//! | `lock=…` | controls that stay as they are, by their names (`locks`) |
//! | `present` | everything half as large again |
//! | `theme=dark`, `theme=light` | in place of the system's theme |
//! | `lang=en`, `lang=de` | in place of the system's language |
//! | `bench` | the paper's tables |
//! | `backend=webgl` | WebGPU is left out |
//!
//! Options that are none of these are left to others (a host may add its own); values that are none
//! are reported.

use super::language::Language;
use super::locks::{Control, Locks};
use super::preferences::Appearance;

/// The options of an address; the default is that of an address without any.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[allow(clippy::struct_excessive_bools, reason = "each is an option of its own, there or not")]
pub struct AddressOptions {
    /// The pictures alone.
    pub embed: bool,
    /// Everything larger.
    pub present: bool,
    /// The paper's tables.
    pub bench: bool,
    /// WebGPU is left out.
    pub webgl: bool,
    /// What stays as it is.
    pub locks: Locks,
    /// The theme, if the address says so.
    pub theme: Option<Appearance>,
    /// The language, if the address says so.
    pub language: Option<Language>,
    /// What could not be understood.
    pub troubles: Vec<String>,
}

const THEMES: [(&str, Appearance); 2] = [("light", Appearance::Light), ("dark", Appearance::Dark)];

impl AddressOptions {
    /// Reads names and values, decoded, in their order.
    pub fn parse<'a>(pairs: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let mut options = Self::default();
        for (name, value) in pairs {
            options.read(name, value);
        }
        options
    }

    fn read(&mut self, name: &str, value: &str) {
        match name {
            "embed" => self.embed = true,
            "present" => self.present = true,
            "bench" => self.bench = true,
            "lock" => self.lock(value),
            "backend" => {
                self.webgl = value.eq_ignore_ascii_case("webgl");
                self.expect(self.webgl, name, value, "webgl");
            }
            "theme" => {
                self.theme = THEMES.into_iter().find(|(theme, _)| value == *theme).map(|(_, theme)| theme);
                self.expect(self.theme.is_some(), name, value, &THEMES.map(|(theme, _)| theme).join(", "));
            }
            "lang" => {
                self.language = Language::ALL.into_iter().find(|language| value == language.code());
                self.expect(self.language.is_some(), name, value, &Language::ALL.map(Language::code).join(", "));
            }
            _ => {}
        }
    }

    fn lock(&mut self, list: &str) {
        let (locks, unknown) = Locks::parse(list);
        self.locks = self.locks.and(locks);
        for name in unknown {
            let known = Control::ALL.map(Control::name).join(", ");
            self.expect(false, "lock", name, &known);
        }
    }

    fn expect(&mut self, is_understood: bool, name: &str, value: &str, known: &str) {
        if !is_understood {
            self.troubles.push(format!("The address says {name}={value}, but {name} knows only: {known}."));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_can_be_asked_for_at_once() {
        let pairs = [("embed", ""), ("lock", "outline,view"), ("present", ""), ("theme", "light"), ("lang", "de")];
        let options = AddressOptions::parse(pairs);
        assert!(options.embed && options.present && !options.bench && !options.webgl);
        assert!(options.locks.holds(Control::Outline) && options.locks.holds(Control::View));
        assert_eq!((options.theme, options.language), (Some(Appearance::Light), Some(Language::German)));
        assert_eq!(options.troubles, [""; 0]);
    }

    #[test]
    fn an_address_without_options_asks_for_nothing_and_others_options_are_left_alone() {
        assert_eq!(AddressOptions::parse([]), AddressOptions::default());
        assert_eq!(AddressOptions::parse([("utm_source", "mail")]), AddressOptions::default());
    }

    #[test]
    fn what_is_not_understood_is_reported_with_what_would_be() {
        let options = AddressOptions::parse([("lock", "outline,vieuw"), ("theme", "blue"), ("backend", "webgpu")]);
        assert!(options.locks.holds(Control::Outline) && options.theme.is_none() && !options.webgl);
        let [lock, theme, backend] = options.troubles.as_slice() else {
            unreachable!("{:?}", options.troubles);
        };
        assert!(lock.contains("lock=vieuw") && lock.contains("boundary"), "{lock}");
        assert!(theme.contains("theme=blue") && theme.contains("light, dark"), "{theme}");
        assert!(backend.contains("backend=webgpu"), "{backend}");
    }

    #[test]
    fn several_locks_add_up() {
        let options = AddressOptions::parse([("lock", "view"), ("lock", "pattern")]);
        assert!(options.locks.holds(Control::View) && options.locks.holds(Control::Pattern));
    }
}
