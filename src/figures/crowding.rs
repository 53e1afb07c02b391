//! Figure 12: maps from the V-shape to the blob by harmonic measure, through the disk, and in closed form.
//!
//! All methods map the same boundary samples, and their maps are extended harmonically into the same
//! mesh, so that only the boundary maps differ. The reference is the composition of the closed forms:
//! the blob's point with the V's harmonic measure.

use super::{ArcLength, FigureError, Scene, Table, planar, prepare_spec};
use crate::conformal::{ConformalMap, Direction, MeshedDomain, PerSide, Side, harmonic_extension};
use crate::exact::{blob, vshape};
use crate::geometry::DVec2;
use crate::mesh::locate;
use crate::outline::{BoundaryPoint, BoundarySamples};
use crate::zipper::{DiskComparison, DiskMap, DiskMeasure};
use std::sync::Arc;

/// A method to compute the boundary map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// The closed forms, used as the reference.
    Exact,
    /// Matching harmonic measure, as riemap does.
    HarmonicMeasure,
    /// The geodesic algorithm, run for x₁ and x₂.
    FreshZipper,
    /// The geodesic algorithm, run once, and a Möbius map.
    PrecomputedZipper,
}

impl Method {
    /// All methods, the reference first.
    pub const ALL: [Self; 4] = [Self::Exact, Self::HarmonicMeasure, Self::FreshZipper, Self::PrecomputedZipper];

    /// The name in a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::HarmonicMeasure => "riemap",
            Self::FreshZipper => "zipper-fresh",
            Self::PrecomputedZipper => "zipper-precomputed",
        }
    }

    /// The name shown to users.
    pub fn title(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::HarmonicMeasure => "riemap (harmonic measure)",
            Self::FreshZipper => "Zipper, run for x₁, x₂",
            Self::PrecomputedZipper => "Zipper once, then Möbius",
        }
    }
}

/// The images of the V's boundary samples under one method.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct BoundaryMap {
    /// The method.
    pub method: Method,
    /// The images of the boundary samples.
    pub images: Vec<DVec2>,
    /// Their arc lengths on the blob, from y₂.
    pub reparameterisation: Vec<f64>,
    /// |f(v_k) − f̃(v_k)|.
    pub errors: Vec<f64>,
    /// How many samples coincide with the previous one in double precision on the disk; 0 if no disk is used.
    pub collapsed: usize,
}

impl BoundaryMap {
    /// E_max and E_mean (section 5.2 of the paper).
    pub fn max_and_mean_error(&self) -> (f64, f64) {
        let sum: f64 = self.errors.iter().sum();
        (self.errors.iter().copied().fold(0.0, f64::max), sum / self.errors.len() as f64)
    }
}

/// The V-shape, the blob, and the maps of the four methods.
#[derive(Debug)]
#[non_exhaustive]
pub struct CrowdingStudy {
    /// riemap's map, with both prepared domains.
    pub map: ConformalMap,
    /// V-shape and blob.
    pub domains: PerSide<Arc<MeshedDomain>>,
    /// x₁ and x₂.
    pub points: PerSide<DVec2>,
    /// The maps in the order of [`Method::ALL`].
    pub maps: [BoundaryMap; 4],
}

/// The center of the V: g(−i) = 0 (section 1.2).
const V_CENTER: DVec2 = DVec2::new(0.0, -1.0);

/// The exact harmonic measures at `x` of points on the exact V, from which the blob's exact map follows.
pub(super) fn exact_measures(points: &[DVec2], x: DVec2) -> Vec<f64> {
    points.iter().map(|&y| vshape::harmonic_measure(x, y)).collect()
}

/// The points of the exact V nearest to samples of its outline, which is a fine polygon. The closed form of the
/// measure holds only on the curve: evaluated at the samples themselves, r would decrease by up to 9e-5 from one
/// sample to the next.
pub(super) fn on_exact_v(samples: &BoundarySamples) -> Vec<DVec2> {
    let arc = ArcLength::new(vshape::boundary, V_PERIOD);
    let foot = |(&p, s): (&DVec2, &f64)| {
        let mut t = arc.parameter(s * arc.total());
        for _ in 0..NEWTON_STEPS {
            let tangent =
                (vshape::boundary(t + TANGENT_STEP) - vshape::boundary(t - TANGENT_STEP)) / (2.0 * TANGENT_STEP);
            t += (p - vshape::boundary(t)).dot(tangent) / tangent.length_squared();
        }
        vshape::boundary(t)
    };
    // the anchor lies on the curve and keeps measure 0
    let first = samples.points().first().copied();
    first.into_iter().chain(samples.points().iter().zip(samples.fractions()).skip(1).map(foot)).collect()
}

/// The parameter of [`vshape::boundary`] runs from 0 to 4.
pub(super) const V_PERIOD: f64 = 4.0;
/// The initial arc lengths are within 1e-5; each Newton step squares the error.
const NEWTON_STEPS: usize = 3;
const TANGENT_STEP: f64 = 1e-6;

impl CrowdingStudy {
    /// The study of a scene from the V-shape to the blob with x₂ = g⁻¹(0), y₁ = 1 + i and y₂ = g⁻¹(1),
    /// for which the exact map is known.
    pub fn new(scene: &Scene) -> Result<Self, FigureError> {
        let [source, target] = Side::BOTH.map(|side| prepare_spec(scene.session.domain(side)));
        let (source, target) = (source?, target?);
        let domains = PerSide::new(planar(&source)?, planar(&target)?);
        let constraints = scene.session.constraints(domains.as_ref().map(|domain| domain.default_point()));
        let points =
            PerSide::from_fn(|side| scene.session.side(side).interior.unwrap_or(domains[side].default_point()));
        let map = ConformalMap::new(source, target, &constraints, Direction::Forward.into())?;
        let maps = Boundaries::new(&map, &domains, points).maps()?;
        Ok(Self { map, domains, points, maps })
    }

    /// The images of all vertices of the V's mesh: the harmonic extension of one boundary map.
    pub fn extended(&self, map: &BoundaryMap) -> Result<Vec<DVec2>, FigureError> {
        let source = self.map.side(Side::Source);
        Ok(harmonic_extension(source, map.images.iter().copied())?)
    }

    /// The image of x₁ under extended `images`, ideally x₂. Infinite if x₁ is not in the mesh.
    pub fn image_of_point(&self, images: &[DVec2]) -> DVec2 {
        let mesh = self.domains.source.mesh();
        locate(mesh, self.points.source, None).map_or(DVec2::INFINITY, |found| {
            let corners = mesh.triangles()[found.triangle().index()];
            corners.iter().zip(found.weights()).map(|(&v, w)| w * images[v as usize]).sum()
        })
    }

    /// The arc lengths of the V's samples from y₁.
    pub fn arc_lengths(&self) -> Vec<f64> {
        let samples = self.domains.source.samples();
        let total: f64 = samples.edge_lengths().iter().sum();
        samples.fractions().iter().map(|s| s * total).collect()
    }

    /// A table with a row for each boundary sample.
    pub fn table(&self) -> Table {
        let mut table = Table::new(&[
            "k",
            "x",
            "y",
            "t",
            "r_exact",
            "r_riemap",
            "r_zipper_fresh",
            "r_zipper_precomputed",
            "error_riemap",
            "error_zipper_fresh",
            "error_zipper_precomputed",
        ]);
        let points = self.domains.source.samples().points();
        for (k, (p, t)) in points.iter().zip(self.arc_lengths()).enumerate() {
            let mut row = vec![k.into(), p.x.into(), p.y.into(), t.into()];
            row.extend(self.maps.iter().map(|map| map.reparameterisation[k].into()));
            row.extend(self.maps[1..].iter().map(|map| map.errors[k].into()));
            table.rows.push(row);
        }
        table
    }
}

/// The inputs that all methods share.
struct Boundaries<'a> {
    map: &'a ConformalMap,
    domains: &'a PerSide<Arc<MeshedDomain>>,
    points: PerSide<DVec2>,
    arc: ArcLength,
    truth: Vec<f64>,
}

impl<'a> Boundaries<'a> {
    fn new(map: &'a ConformalMap, domains: &'a PerSide<Arc<MeshedDomain>>, points: PerSide<DVec2>) -> Self {
        let truth = exact_measures(&on_exact_v(domains.source.samples()), points.source);
        Self { map, domains, points, arc: ArcLength::new(blob::boundary, 1.0), truth }
    }

    fn maps(&self) -> Result<[BoundaryMap; 4], FigureError> {
        let [fresh, precomputed] = [self.fresh()?, self.precomputed()?];
        let exact = BoundaryMap {
            method: Method::Exact,
            images: self.truth.iter().map(|&omega| blob::boundary(omega)).collect(),
            reparameterisation: self.truth.iter().map(|&omega| self.arc.at(omega)).collect(),
            errors: vec![0.0; self.truth.len()],
            collapsed: 0,
        };
        let points = self.map.correspondence().points();
        Ok([
            exact,
            self.matched(Method::HarmonicMeasure, points, 0),
            self.matched(Method::FreshZipper, fresh.points(), collapsed(&fresh)),
            self.matched(Method::PrecomputedZipper, precomputed.points(), collapsed(&precomputed)),
        ])
    }

    fn anchors(&self) -> [BoundaryPoint; 2] {
        Side::BOTH.map(|side| self.map.measure(side).anchor())
    }

    fn fresh(&self) -> Result<DiskComparison, FigureError> {
        let [y1, y2] = self.anchors();
        Ok(DiskComparison::new(
            DiskMeasure::fresh(self.domains.source.samples().points(), self.points.source, y1)?,
            DiskMeasure::fresh(self.domains.target.samples().points(), self.points.target, y2)?,
        ))
    }

    fn precomputed(&self) -> Result<DiskComparison, FigureError> {
        let [y1, y2] = self.anchors();
        let source = DiskMap::new(self.domains.source.samples().points(), V_CENTER)?;
        let target = DiskMap::new(self.domains.target.samples().points(), self.domains.target.default_point())?;
        Ok(DiskComparison::new(
            DiskMeasure::precomputed(&source, self.points.source, y1)?,
            DiskMeasure::precomputed(&target, self.points.target, y2)?,
        ))
    }

    fn matched(&self, method: Method, points: &[BoundaryPoint], collapsed: usize) -> BoundaryMap {
        let samples = self.domains.target.samples();
        let images: Vec<DVec2> = points.iter().map(|&p| samples.position(p)).collect();
        let errors = images.iter().zip(&self.truth).map(|(w, &omega)| w.distance(blob::boundary(omega))).collect();
        let total = self.arc.total();
        let reparameterisation = points.iter().map(|&p| total * samples.fraction_at(p)).collect();
        BoundaryMap { method, images, reparameterisation, errors, collapsed }
    }
}

fn collapsed(comparison: &DiskComparison) -> usize {
    comparison.mapped().collapsed()
}
