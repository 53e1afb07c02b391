//! Short loops of constant length, unrolled.
//!
//! The web app is compiled for size, and the compiler then does not unroll such loops; in the
//! innermost steps of the factorization and of the sweeps that costs a factor of two (measured).

/// Executes `body` with `index` = 0, 1, … below `count`, which is a constant of at most 8.
macro_rules! unrolled {
    ($index:ident < $count:expr => $body:expr) => {
        unrolled!(@steps $index, $count, $body, 0 1 2 3 4 5 6 7)
    };
    (@steps $index:ident, $count:expr, $body:expr, $($step:literal)*) => {
        $(if $step < $count {
            let $index: usize = $step;
            $body;
        })*
    };
}

pub(super) use unrolled;

#[cfg(test)]
mod tests {
    /// The values of the index, in order.
    fn steps<const N: usize>() -> Vec<usize> {
        let mut taken = Vec::new();
        unrolled!(k < N => taken.push(k));
        taken
    }

    #[test]
    fn every_step_is_taken_once_and_in_order() {
        assert!(steps::<0>().is_empty());
        assert_eq!(steps::<3>(), [0, 1, 2]);
        assert_eq!(steps::<8>(), [0, 1, 2, 3, 4, 5, 6, 7]);
    }
}
