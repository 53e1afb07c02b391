//! The zero crossing of a non-decreasing function, by false position within a bracket.
//!
//! Anderson and Björck (1973): a secant of the bracket; if one end is kept twice, its value is scaled down by the
//! factor by which the other end's value has decreased, so that both ends converge. Order 1.7 for a smooth function.
//! If three steps do not halve the bracket, it is bisected, so that for functions with steps, flat parts or rounding
//! errors the cost is at most four times that of bisection.

/// The point at which `excess` goes from ≤ 0 to > 0, with an error of at most half the `tolerance`.
///
/// `bracket` holds two arguments and the values of `excess` there, ≤ 0 at the first and > 0 at the second. Otherwise,
/// or if `excess` is not monotone, the result is some point between the two.
pub fn crossing(excess: impl Fn(f64) -> f64, bracket: [(f64, f64); 2], tolerance: f64) -> f64 {
    let [(mut low, mut below), (mut high, mut above)] = bracket;
    let mut widths = [f64::INFINITY; 3];
    // which end was replaced last
    let mut came_low = None;
    while high - low > tolerance {
        let width = high - low;
        let part = below / (below - above);
        let place = if width > 0.5 * widths[0] || part.is_nan() {
            low + 0.5 * width
        } else {
            // keep a distance from the ends, so that the other end converges too
            (low + part * width).clamp(low + 0.5 * tolerance, high - 0.5 * tolerance)
        };
        widths = [widths[1], widths[2], width];
        if place <= low || place >= high {
            break; // adjacent floating-point numbers
        }
        let value = excess(place);
        if value <= 0.0 {
            above *= if came_low == Some(true) { scale(value, below) } else { 1.0 };
            (low, below, came_low) = (place, value, Some(true));
        } else {
            below *= if came_low == Some(false) { scale(value, above) } else { 1.0 };
            (high, above, came_low) = (place, value, Some(false));
        }
    }
    0.5 * (low + high)
}

/// The factor for the value at the end that is kept, in (0, 1].
fn scale(value: f64, before: f64) -> f64 {
    let scale = 1.0 - value / before;
    if scale > 0.0 { scale } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    /// The crossing between 0 and 1 of a function, and the number of evaluations.
    fn counted(excess: impl Fn(f64) -> f64) -> (f64, u32) {
        let calls = Cell::new(0);
        let ends = [(0.0, excess(0.0)), (1.0, excess(1.0))];
        let found = crossing(
            |x| {
                calls.set(calls.get() + 1);
                excess(x)
            },
            ends,
            1e-12,
        );
        (found, calls.get())
    }

    #[test]
    fn smooth_functions_take_a_few_steps() {
        for root in [1e-9, 0.1, 0.3, 0.77, 1.0 - 1e-9] {
            for bend in [-0.4, 0.0, 0.4] {
                let smooth = |x: f64| x + bend * x * (1.0 - x);
                let (found, calls) = counted(|x| smooth(x) - smooth(root));
                println!("{root}, {bend}: {found}, {calls} calls");
                assert!((found - root).abs() < 1e-12 && calls <= 7, "{root}, {bend}: {found} after {calls} calls");
            }
        }
    }

    #[test]
    fn roots_steps_and_flat_pieces_are_found_as_surely_as_by_bisection() {
        // bisection takes 40 evaluations
        let check = |name: &str, root: f64, excess: &dyn Fn(f64) -> f64| {
            let (found, calls) = counted(excess);
            println!("{name}: {found}, {calls} calls");
            assert!((found - root).abs() < 1e-12 && calls <= 160, "{name}: {found} for {root} after {calls} calls");
        };
        check("a root", 0.04, &|x| x.sqrt() - 0.2);
        check("a high power", 0.9, &|x| x.powi(40) - 0.9_f64.powi(40));
        check("a step", 0.3, &|x| if x <= 0.3 { -1.0 } else { 1e-9 });
        check("the end of a flat piece", 0.7, &|x| if x <= 0.7 { 0.0 } else { x });
        check("a flat piece before a step", 0.7, &|x| if x <= 0.2 { x - 0.2 } else { f64::from(u8::from(x > 0.7)) });
        check("nothing below", 0.0, &|x| x + 0.1);
        check("nothing above", 1.0, &|x| x - 1.0);
        check("no number", 0.0, &|_| f64::NAN);
    }
}
