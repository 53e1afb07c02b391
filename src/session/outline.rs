//! An outline in a session: a preset, or a loaded polygon that is known to be simple, with the form of its curve.

use crate::conformal::PrepareSettings;
use crate::geometry::{CurveError, DVec2, SimplePolygon};
use crate::outline::{CurveForm, CurveSource, Outline, OutlineCurve, Preset};
use serde::{Serialize, Serializer};

/// Where a domain's outline comes from. As JSON a loaded outline is its points and, unless they are only a polygon, the
/// form of its curve; `file` reads it.
#[derive(Debug, Clone, PartialEq)]
pub enum OutlineSpec {
    /// A built-in outline.
    Preset(Preset),
    /// A loaded outline.
    Points {
        /// Its name.
        name: String,
        /// The polygon, checked when it was read.
        polygon: SimplePolygon,
        /// How its curve is found from the polygon.
        form: CurveForm,
    },
}

impl OutlineSpec {
    /// A loaded list of points, to be interpreted automatically.
    pub fn points(name: String, polygon: SimplePolygon) -> Self {
        Self::Points { name, polygon, form: CurveForm::default() }
    }

    /// This outline with another form of its curve; a preset is always its own curve.
    #[must_use]
    pub fn with_form(self, form: CurveForm) -> Self {
        match self {
            Self::Points { name, polygon, .. } => Self::Points { name, polygon, form },
            preset @ Self::Preset(_) => preset,
        }
    }

    /// The outline as a polygon; computed for a preset, a copy of a loaded one. Cost O(k).
    pub fn polygon(&self) -> SimplePolygon {
        match self {
            Self::Preset(preset) => preset.outline().into_polygon(),
            Self::Points { polygon, .. } => polygon.clone(),
        }
    }

    /// Where the boundary point of a side with this new outline begins, as a fraction of the boundary's length: the
    /// first point of a preset, which is made for it, and the top-most point of any other outline, so that it is
    /// mapped upright.
    pub fn first_anchor(&self) -> f64 {
        match self {
            Self::Preset(_) => 0.0,
            Self::Points { polygon, .. } => polygon.fraction_of_top(),
        }
    }

    /// The outline as a curve. Errors: as [`CurveForm::curve`].
    pub fn curve(&self) -> Result<OutlineCurve, CurveError> {
        match self {
            Self::Preset(preset) => preset.outline().curve(),
            Self::Points { polygon, form, .. } => form.curve(polygon),
        }
    }

    /// The places of the outline's corners: [`CurveForm::corner_places`].
    pub fn corner_places(&self) -> Vec<DVec2> {
        match self {
            Self::Preset(preset) => preset.outline().corner_places(),
            Self::Points { polygon, form, .. } => form.corner_places(polygon),
        }
    }

    /// The form of this outline's curve for an edited form of its polygon: the interpretation stays, and the vertices
    /// that were switched, where the edited polygon has them. An edited path is a list of points.
    pub fn carried_form(&self, edited: &SimplePolygon) -> CurveForm {
        let Self::Points { polygon, form, .. } = self else { return CurveForm::default() };
        let (old, new) = (polygon.vertices(), edited.vertices());
        let same_order = old.len() == new.len() && old.iter().zip(new).filter(|(a, b)| a == b).count() > old.len() / 4;
        let count = old.len();
        let is_mirrored = count == new.len() && (0..count).all(|k| new[k].y == old[(count - k) % count].y);
        let carried = |&vertex: &u32| {
            let place = old.get(vertex as usize)?;
            if same_order {
                Some(vertex)
            } else if is_mirrored {
                Some((count as u32 - vertex) % count as u32)
            } else {
                new.iter().position(|p| p == place).map(|k| k as u32)
            }
        };
        let mut switched: Vec<u32> = form.switched.iter().filter_map(carried).collect();
        switched.sort_unstable();
        CurveForm { interpretation: form.interpretation, switched, ..CurveForm::default() }
    }

    /// Whether the form of the curve is what the polygon alone says: before curves, outlines were stored without.
    pub(in crate::session) fn is_only_polygon(&self) -> bool {
        match self {
            Self::Preset(_) => true,
            Self::Points { polygon, form, .. } => *form == CurveForm::of_polygon(polygon),
        }
    }

    /// The number of points of a loaded outline; 0 for a preset.
    pub fn loaded_points(&self) -> usize {
        match self {
            Self::Preset(_) => 0,
            Self::Points { polygon, .. } => polygon.vertices().len(),
        }
    }
}

impl From<Outline> for OutlineSpec {
    /// Drops the reader's notes. The outline of a preset becomes a list of points.
    fn from(outline: Outline) -> Self {
        let (name, mut form) = (outline.name().to_owned(), outline.form().clone());
        if matches!(form.source, CurveSource::Preset(_)) {
            form.source = CurveSource::Points;
        }
        Self::Points { name, polygon: outline.into_polygon(), form }
    }
}

impl Serialize for OutlineSpec {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        #[serde(rename_all = "kebab-case")]
        enum Written<'a> {
            Preset(Preset),
            Points {
                name: &'a str,
                points: &'a [DVec2],
                #[serde(skip_serializing_if = "Option::is_none")]
                curve: Option<&'a CurveForm>,
            },
        }
        let written = match self {
            Self::Preset(preset) => Written::Preset(*preset),
            Self::Points { name, polygon, form } => {
                let curve = (!self.is_only_polygon()).then_some(form);
                Written::Points { name, points: polygon.vertices(), curve }
            }
        };
        written.serialize(serializer)
    }
}

/// An outline and how its interior is discretized.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct DomainSpec {
    /// The outline.
    pub outline: OutlineSpec,
    /// How it is discretized.
    pub settings: PrepareSettings,
}

impl DomainSpec {
    /// An outline with these settings.
    pub fn new(outline: OutlineSpec, settings: PrepareSettings) -> Self {
        Self { outline, settings }
    }
}
