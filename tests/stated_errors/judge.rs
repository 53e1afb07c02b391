//! What is collected of a case, and the verdict on a kind.

use riemap::boundary_integral::Estimate;

/// A number's stated error and the true one.
pub struct Number {
    pub stated: f64,
    /// The true error, less what is not known of the truth.
    pub off: f64,
    /// The difference from the truth.
    pub apart: f64,
}

impl Number {
    /// A number that is `apart` from a truth known to `slack`.
    pub fn new(stated: f64, apart: f64, slack: f64) -> Self {
        Self { stated, off: if apart <= slack { 0.0 } else { apart - slack }, apart }
    }
}

/// A case: all the numbers of one result.
pub struct Case {
    pub kind: &'static str,
    pub name: String,
    /// The numbers, or why there are none.
    pub found: Result<Vec<Number>, String>,
}

impl Case {
    pub fn new(kind: &'static str, name: impl Into<String>, found: Result<Vec<Number>, String>) -> Self {
        Self { kind, name: name.into(), found }
    }

    /// Whether every number is covered.
    pub fn is_covered(&self) -> bool {
        self.found.as_ref().is_ok_and(|numbers| numbers.iter().all(|number| number.off <= number.stated))
    }

    /// The median ratio of stated to true error, of the numbers whose true error is known.
    pub fn ratio(&self) -> Option<f64> {
        let numbers = self.found.as_ref().ok()?.iter().filter(|number| number.off > 0.0);
        median(numbers.map(|number| number.stated / number.apart).collect())
    }

    fn describe(&self) -> String {
        match &self.found {
            Err(reason) => format!("{}: refused, {reason}", self.name),
            Ok(numbers) => {
                let worst = numbers.iter().max_by(|a, b| (a.off - a.stated).total_cmp(&(b.off - b.stated)));
                let worst = worst.map(|n| format!("off by {:.1e}, stated {:.1e}", n.off, n.stated));
                let open = numbers.iter().filter(|n| n.off.is_nan() || n.off > n.stated).count();
                format!("{}: {open} of {} open, {}", self.name, numbers.len(), worst.unwrap_or_default())
            }
        }
    }
}

/// An estimate against the truth, which is known to `slack`.
pub fn number(found: Estimate, truth: f64, slack: f64) -> Number {
    Number::new(found.error, (found.value - truth).abs(), slack)
}

/// Two estimates whose values are equal: the difference against the sum of the errors.
pub fn pair(a: Estimate, b: Estimate, slack: f64) -> Number {
    number(Estimate { value: a.value - b.value, error: a.error + b.error }, 0.0, slack)
}

pub fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

/// The share of a kind that is to be covered, of all cases, and the most that errors are too large in the median.
const OF_A_KIND: f64 = 0.95;
const OF_ALL: f64 = 0.99;
const TOO_LARGE: f64 = 100.0;

/// Prints the table by kind and asserts the shares, of the cases that are not in `known`, where each is with its cause; a
/// known case that is covered is to be taken from the list. `large` are the kinds with larger errors than is asked.
pub fn judge(cases: &[Case], known: &[(&str, &str)], large: &[&str]) {
    let mut kinds: Vec<&str> = Vec::new();
    for case in cases {
        if !kinds.contains(&case.kind) {
            kinds.push(case.kind);
        }
    }
    let mut wrong = Vec::new();
    let is_known = |case: &Case| known.iter().any(|(name, _)| *name == case.name);
    for case in cases.iter().filter(|case| !case.is_covered()) {
        println!("not covered: [{}] {}{}", case.kind, case.describe(), if is_known(case) { " (known)" } else { "" });
    }
    println!("{:<26} {:>5} {:>8} {:>9} {:>8}", "kind", "cases", "covered", "too large", "refused");
    for kind in kinds {
        let own: Vec<&Case> = cases.iter().filter(|case| case.kind == kind).collect();
        let covered = own.iter().filter(|case| case.is_covered()).count();
        let refused = own.iter().filter(|case| case.found.is_err()).count();
        let ratio = median(own.iter().filter_map(|case| case.ratio()).collect()).unwrap_or(f64::NAN);
        println!("{kind:<26} {:>5} {covered:>8} {ratio:>9.1} {refused:>8}", own.len());
        let asked = own.iter().filter(|case| !is_known(case)).count();
        let open = own.iter().filter(|case| !is_known(case) && !case.is_covered()).count();
        if (open as f64) > (1.0 - OF_A_KIND) * asked as f64 {
            wrong.push(format!("{kind}: {open} of {asked} are not covered"));
        }
        if (ratio > TOO_LARGE) != large.contains(&kind) {
            wrong.push(format!("{kind}: {ratio:.0} times too large"));
        }
    }
    let covered = cases.iter().filter(|case| case.is_covered()).count();
    println!("{covered} of {} covered", cases.len());
    let open = cases.iter().filter(|case| !is_known(case) && !case.is_covered()).count();
    if open as f64 > (1.0 - OF_ALL) * cases.len() as f64 {
        wrong.push(format!("{open} of all are not covered"));
    }
    for (name, cause) in known {
        match cases.iter().find(|case| case.name == *name) {
            None => wrong.push(format!("{name} is no case")),
            Some(case) if case.is_covered() => {
                wrong.push(format!("{name} ({cause}) is covered: take it from the list"));
            }
            Some(_) => (),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
