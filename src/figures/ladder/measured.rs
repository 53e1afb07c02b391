//! Errors and times that all methods of the ladder report.

use super::{Errors, FigureError, ImageOf};
use crate::exact::blob;
use crate::geometry::DVec2;
use std::f64::consts::TAU;
use web_time::Instant;

use super::truth::Truth;

/// What is measured of a rung.
#[derive(Debug, Clone, Copy)]
pub struct Measured {
    pub m: usize,
    pub unknowns: usize,
    pub omega: Errors,
    pub image: Option<Errors>,
    pub prepare_ms: f64,
    pub point_ms: f64,
}

impl Errors {
    /// Of the absolute values. Zero without errors; not finite if one is not.
    pub fn of(errors: impl IntoIterator<Item = f64>) -> Self {
        let (mut max, mut sum, mut count) = (0.0_f64, 0.0, 0.0_f64);
        for error in errors {
            let error = error.abs();
            max = if error <= max { max } else { error };
            sum += error;
            count += 1.0;
        }
        Self { max, mean: sum / count.max(1.0) }
    }
}

/// Runs `work` several times; the last result and the median of the milliseconds.
pub fn timed<T>(runs: usize, mut work: impl FnMut() -> Result<T, FigureError>) -> Result<(T, f64), FigureError> {
    let mut run = || -> Result<(T, f64), FigureError> {
        let start = Instant::now();
        let result = work()?;
        Ok((result, 1e3 * start.elapsed().as_secs_f64()))
    };
    let (mut result, first) = run()?;
    let mut times = vec![first];
    for _ in 1..runs {
        let (again, time) = run()?;
        result = again;
        times.push(time);
    }
    times.sort_unstable_by(f64::total_cmp);
    Ok((result, times[times.len() / 2]))
}

/// The exact image of the boundary point with measure `omega` on the side that is mapped.
pub fn exact_image(truth: &Truth, image_of: ImageOf, omega: f64) -> Option<DVec2> {
    match image_of {
        ImageOf::OntoDisk => Some(DVec2::from_angle(TAU * omega)),
        ImageOf::OntoBlob => Some(blob::boundary(omega)),
        ImageOf::DiskOnto => truth.point(omega),
        ImageOf::Unknown => None,
    }
}
