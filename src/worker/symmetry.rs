//! The symmetries of an outline, as a study: the request and its result, which cross to the worker as bytes.

use super::StudiedOutline;
use crate::geometry::{DVec2, Symmetries};
use crate::language::Message;
use serde::{Deserialize, Serialize};

/// The symmetries of an outline, and where its axes end.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FoundSymmetries {
    /// The symmetries.
    pub symmetries: Symmetries,
    /// The points in which each axis meets the outline, in the order of the axes.
    pub ends: Vec<Vec<DVec2>>,
}

impl StudiedOutline {
    /// Finds the symmetries of the outline's polygon. Errors: it is no simple polygon.
    pub fn symmetries(&self) -> Result<FoundSymmetries, Message> {
        let polygon = self.spec()?.polygon();
        let symmetries = Symmetries::of(&polygon);
        let vertices = polygon.vertices();
        let place = |(edge, along): (usize, f64)| vertices[edge].lerp(vertices[(edge + 1) % vertices.len()], along);
        let ends = symmetries.axes.iter().map(|axis| axis.crossings(&polygon).into_iter().map(place).collect());
        Ok(FoundSymmetries { ends: ends.collect(), symmetries })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::outline::Preset;
    use crate::worker::{Finding, Study, packed, unpacked};

    #[test]
    fn the_stars_axes_end_in_its_points_and_notches() {
        let study = Study::Symmetry(Box::new(StudiedOutline::Preset(Preset::Star)));
        assert_eq!(unpacked::<Study>(&packed(&study)).as_ref(), Some(&study));
        let finding = study.run(&mut |_| true).unwrap();
        assert_eq!(unpacked::<Finding>(&packed(&finding)).as_ref(), Some(&finding));
        let Finding::Symmetry(found) = finding else { panic!("{finding:?}") };
        let corners = Preset::Star.outline().corner_places();
        assert_eq!(found.ends.len(), 5);
        for end in found.ends.iter().flatten() {
            assert!(corners.iter().any(|corner| corner.distance(*end) < 1e-14), "{end}");
        }
        assert!(found.ends.iter().all(|ends| ends.len() == 2), "{found:?}");
    }
}
