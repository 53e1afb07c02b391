//! The map projection of least distortion of a region, as a study: what a window shows, and both files.
//!
//! The files are those of `riemap project`, to the byte.

use crate::export::{Line, ProjectionFormat, ProjectionReport, ScaleLines, scale_lines};
use crate::geometry::DVec2;
use crate::language::{Message, Value, key};
use crate::outline::{GeoRing, Reading, parse_geo_rings};
use crate::projection::{Projection, ProjectionError, Region, island};
use serde::{Deserialize, Serialize};

/// The share of the work up to the map; the rest are the files.
const MAPPED: f64 = 0.9;

/// A region of the sphere.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProjectionTask {
    /// That of a `GeoJSON` file in longitude and latitude.
    File {
        /// The file's name.
        name: String,
        /// Its content.
        bytes: Vec<u8>,
        /// The number of the feature that is meant, counted from 1; all if there is none.
        feature: Option<usize>,
        /// Whether rings that cross or touch themselves are mended.
        repair: bool,
    },
    /// The island by formula.
    Island,
}

/// A feature of a file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Feature {
    /// Its number, counted from 1.
    pub number: usize,
    /// Its name.
    pub name: Option<String>,
}

/// Why there is no projection, and what may help.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RefusedProjection {
    /// The reason.
    pub reason: Message,
    /// Whether repairs would give a region.
    pub repairable: bool,
    /// The features of the file, if it has several.
    pub features: Vec<Feature>,
}

/// A projection as it is drawn, its numbers, and its files.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FoundProjection {
    /// The numbers.
    pub report: ProjectionReport,
    /// The boundary.
    pub outline: Vec<DVec2>,
    /// The region.
    pub land: Land,
    /// Meridians and parallels.
    pub graticule: Vec<Vec<DVec2>>,
    /// The steps of longitude and latitude, in degrees.
    pub steps: DVec2,
    /// The lines of equal scale.
    pub scales: Vec<DrawnScale>,
    /// The files, in the order of [`ProjectionFormat::ALL`].
    pub files: [String; 2],
    /// The number of points that repairs cut off; `None` if no ring was mended.
    pub cut: Option<usize>,
    /// The features of the region's file, if it has several.
    pub features: Vec<Feature>,
}

/// A region as triangles, in single precision: it is only painted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Land {
    /// The vertices.
    pub vertices: Vec<[f32; 2]>,
    /// The scale at each vertex.
    pub scales: Vec<f32>,
    /// The triangles.
    pub triangles: Vec<[u32; 3]>,
}

/// The lines on which the scale has a value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DrawnScale {
    /// The value.
    pub label: String,
    /// The lines; closed ones end where they begin.
    pub lines: Vec<Vec<DVec2>>,
}

impl ProjectionTask {
    /// All of a file, without repairs.
    pub fn of_file(name: &str, bytes: Vec<u8>) -> Self {
        Self::File { name: name.to_owned(), bytes, feature: None, repair: false }
    }

    /// The same with the feature of this number alone, or with all.
    #[must_use]
    pub fn with_feature(self, feature: Option<usize>) -> Self {
        match self {
            Self::File { name, bytes, repair, .. } => Self::File { name, bytes, feature, repair },
            Self::Island => Self::Island,
        }
    }

    /// The same with repairs.
    #[must_use]
    pub fn repaired(self) -> Self {
        match self {
            Self::File { name, bytes, feature, .. } => Self::File { name, bytes, feature, repair: true },
            Self::Island => Self::Island,
        }
    }

    /// The file's name without its extension, or "island".
    pub fn stem(&self) -> &str {
        match self {
            Self::File { name, .. } => name.rsplit_once('.').map_or(name, |(stem, _)| stem),
            Self::Island => "island",
        }
    }

    /// The rings of all features.
    fn rings(&self) -> Result<Vec<GeoRing>, Message> {
        match self {
            Self::File { bytes, repair, .. } => {
                let how = Reading { repair: *repair, part: None };
                parse_geo_rings(bytes, &how).map_err(|error| Message::from(&error))
            }
            Self::Island => Ok(vec![GeoRing::new(island()).named("Island")]),
        }
    }

    /// Whether it is of a file that is not repaired, and repairs would give a region.
    fn is_repairable(&self) -> bool {
        let Self::File { feature, repair: false, .. } = self else { return false };
        let rings = self.clone().repaired().rings();
        rings.is_ok_and(|rings| region(&of_feature(rings, *feature)).is_ok())
    }

    /// The number of the feature that is meant alone.
    pub fn feature(&self) -> Option<usize> {
        if let Self::File { feature, .. } = self { *feature } else { None }
    }

    /// Computes the projection. `report` gets the share that is done, which may also fall, and returns whether to go on;
    /// `None` if it said no.
    ///
    /// Errors: what is wrong with the file or the region, in words.
    pub fn run(&self, report: &mut dyn FnMut(f64) -> bool) -> Result<Option<FoundProjection>, Box<RefusedProjection>> {
        let refused = |reason: Message, repairable: bool, features: Vec<Feature>| {
            Box::new(RefusedProjection { reason, repairable, features })
        };
        let rings = self.rings().map_err(|reason| refused(reason, false, Vec::new()))?;
        let features = features(&rings);
        let rings = of_feature(rings, self.feature());
        let region = match region(&rings) {
            Ok(region) => region,
            Err(error) => return Err(refused(Message::from(&error), self.is_repairable(), features)),
        };
        match Projection::telling(region, &mut |done| report(MAPPED * done)) {
            Ok(projection) if report(MAPPED) => Ok(Some(self.found(&rings, &projection, features))),
            Ok(_) | Err(ProjectionError::Cancelled) => Ok(None),
            Err(error) => Err(refused(Message::from(&error), false, features)),
        }
    }

    fn found(&self, rings: &[GeoRing], projection: &Projection, features: Vec<Feature>) -> FoundProjection {
        let graticule = projection.graticule();
        FoundProjection {
            report: ProjectionReport::new(self.stem(), rings, projection),
            outline: projection.boundary().to_vec(),
            land: Land::of(projection),
            steps: graticule.steps,
            graticule: [graticule.meridians, graticule.parallels].concat(),
            scales: scale_lines(projection).into_iter().map(DrawnScale::from).collect(),
            files: ProjectionFormat::ALL.map(|format| format.text(projection)),
            cut: rings.iter().filter_map(|ring| ring.cut).reduce(|all, cut| all + cut),
            features,
        }
    }
}

fn of_feature(rings: Vec<GeoRing>, feature: Option<usize>) -> Vec<GeoRing> {
    rings.into_iter().filter(|ring| feature.is_none_or(|feature| ring.feature == feature)).collect()
}

fn region(rings: &[GeoRing]) -> Result<Region, ProjectionError> {
    let points: Vec<Vec<DVec2>> = rings.iter().map(|ring| ring.points.clone()).collect();
    Region::new(&points)
}

/// The features around rings, in the file's order; none if there is only one.
fn features(rings: &[GeoRing]) -> Vec<Feature> {
    let mut all: Vec<Feature> =
        rings.iter().map(|ring| Feature { number: ring.feature, name: ring.name.clone() }).collect();
    all.dedup_by_key(|feature| feature.number);
    if all.len() > 1 { all } else { Vec::new() }
}

impl Land {
    fn of(projection: &Projection) -> Self {
        Self {
            vertices: projection.images().iter().map(|p| p.as_vec2().to_array()).collect(),
            scales: projection.scales().into_iter().map(|k| k as f32).collect(),
            triangles: projection.mesh().triangles().to_vec(),
        }
    }
}

impl From<ScaleLines> for DrawnScale {
    fn from(ScaleLines { label, lines, .. }: ScaleLines) -> Self {
        let drawn = |Line { mut points, is_closed }: Line| {
            points.extend(points.first().copied().filter(|_| is_closed));
            points
        };
        Self { label, lines: lines.into_iter().map(drawn).collect() }
    }
}

impl FoundProjection {
    /// What is not in the map, and what is in it twice.
    pub fn notes(&self) -> Vec<Message> {
        let ProjectionReport { rings, rings_left_out: left, share, holes_filled: holes, .. } = &self.report;
        let decimals = |x: f64, count: usize| Value::number(format!("{x:.count$}"));
        let overlap = |[lon, lat]: [f64; 2]| key::projection_overlaps(decimals(lon, 4), decimals(lat, 4));
        let notes = [
            (*left > 0).then(|| key::projection_left_out(decimals(100.0 * share, 1), *left)),
            (rings.len() > 1).then(|| key::projection_joined(rings.len())),
            self.cut.map(key::projection_mended),
            (*holes > 0).then(|| key::projection_holes(*holes)),
            self.report.is_stereographic.then(|| key::projection_is_stereographic().into()),
            self.report.overlap_at.map(overlap),
        ];
        notes.into_iter().flatten().collect()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::worker::{packed, unpacked};

    #[test]
    fn the_island_is_mapped_better_than_stereographically_and_crosses_as_bytes() {
        let task = ProjectionTask::Island;
        let (mut shares, mut count) = (0.0_f64, 0);
        let found = task.run(&mut |done| {
            (shares, count) = (shares.max(done), count + 1);
            true
        });
        let found = found.unwrap().unwrap();
        let FoundProjection { report, outline, scales, .. } = &found;
        assert!(report.scale_ratio > 1.0 && report.scale_ratio < report.stereographic_scale_ratio - 1e-3, "{report:?}");
        assert!(report.residual < 1e-4 && !report.overlaps && found.notes().is_empty(), "{report:?}");
        let counts = [outline.len(), scales.len(), found.graticule.len()];
        assert!(counts[0] >= 60 && counts[1] > 0 && counts[2] > 3, "{counts:?}");
        assert!(count > 3 && (shares - MAPPED).abs() < 1e-9, "{count} reports up to {shares}");
        assert_eq!(unpacked::<FoundProjection>(&packed(&found)).unwrap(), found);
        assert!(found.files[0].starts_with("<svg") && found.files[1].starts_with("lon,lat,x,y\n"));
    }

    #[test]
    fn a_projection_is_cancelled_and_refused_in_words() {
        assert_eq!(ProjectionTask::Island.run(&mut |done| done < 0.1), Ok(None));
        let refused = |text: &str| {
            let task = ProjectionTask::of_file("a.geojson", text.into());
            task.run(&mut |_| true).unwrap_err().reason.english()
        };
        let array = refused("[[0,0],[1,0],[0,1]]");
        assert!(array.contains("has no \"type\""), "{array}");
        let high = r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,95],[0,0]]]}"#;
        assert!(refused(high).contains("latitude 95°"), "{}", refused(high));
    }

    #[test]
    fn a_feature_is_projected_alone_and_a_touching_ring_after_repairs() {
        let feature = |name: &str, ring: &str| {
            format!(
                r#"{{"type":"Feature","properties":{{"name":"{name}"}},"geometry":{{"type":"Polygon","coordinates":[[{ring}]]}}}}"#
            )
        };
        // the second one runs through a point of its boundary twice
        let square = feature("square", "[0,0],[4,0],[4,4],[0,4],[0,0]");
        let knot = feature("knot", "[10,0],[16,0],[16,6],[13,6],[13.2,6.2],[12.8,6.2],[13,6],[10,6],[10,0]");
        let text = format!(r#"{{"type":"FeatureCollection","features":[{square},{knot}]}}"#);
        let task = ProjectionTask::of_file("two.geojson", text.into());
        let refused = task.run(&mut |_| true).unwrap_err();
        assert!(refused.repairable, "{}", refused.reason.english());
        let names: Vec<_> = refused.features.iter().map(|feature| feature.name.as_deref()).collect();
        assert_eq!(names, [Some("square"), Some("knot")]);
        let alone = task.clone().with_feature(Some(1)).run(&mut |_| true).unwrap().unwrap();
        assert_eq!((alone.report.name.as_str(), alone.cut, alone.features.len()), ("square", None, 2));
        let mended = task.with_feature(Some(2)).repaired().run(&mut |_| true).unwrap().unwrap();
        assert_eq!((mended.report.name.as_str(), mended.cut.is_some()), ("knot", true));
        assert!(mended.notes().iter().any(|note| note.english().contains("cut off")), "{:?}", mended.notes());
    }

    #[test]
    fn what_is_left_out_and_filled_is_noted() {
        let square =
            |x: f64, size: f64| format!("[[[{x},0],[{},0],[{},{size}],[{x},{size}],[{x},0]]]", x + size, x + size);
        let text = format!(r#"{{"type":"MultiPolygon","coordinates":[{},{}]}}"#, square(0.0, 4.0), square(10.0, 1.0));
        let task = ProjectionTask::of_file("two.geojson", text.into());
        let found = task.run(&mut |_| true).unwrap().unwrap();
        assert_eq!(found.report.name, "two");
        let words: Vec<String> = found.notes().iter().map(Message::english).collect();
        assert!(words.len() == 1 && words[0].contains("94.1 %"), "{words:?}");
    }
}
