//! The interpretation of a side's outline: what is asked for, what its points were taken for, and the commands that
//! change it.

use crate::conformal::{KernelMode, Side};
use crate::geometry::DVec2;
use crate::model::Model;
use crate::outline::{CurveForm, Interpretation};
use crate::session::{Command, OutlineSpec};
use crate::worker::{Corner, Taken};

/// The interpretation of an outline that is given by points or by a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interpreting<'a> {
    /// What is asked for.
    pub asked: Interpretation,
    /// What the points were taken for.
    pub taken: &'a Taken,
}

impl Model {
    /// The interpretation of a side's outline; `None` for a surface or a preset, where finite elements were chosen, and
    /// until the outline is prepared.
    pub fn interpretation(&self, side: Side) -> Option<Interpreting<'_>> {
        let (outline, settings) = (self.reshapable(side)?, self.side(side).wanted().settings);
        let OutlineSpec::Points { form, .. } = outline else { return None };
        let taken = self.side(side).taken().filter(|_| settings.kernel == KernelMode::Integral)?;
        Some(Interpreting { asked: form.interpretation, taken })
    }

    /// The vertices of a side's outline that can be switched between corner and smooth, with their places.
    pub fn corners(&self, side: Side) -> impl Iterator<Item = (Corner, DVec2)> + '_ {
        let taken = self.interpretation(side).map(|interpreting| interpreting.taken);
        let polygon = match &self.session.domain(side).outline {
            OutlineSpec::Points { polygon, .. } => polygon.vertices(),
            OutlineSpec::Preset(_) => &[],
        };
        let corners = taken.into_iter().flat_map(|taken| &taken.corners);
        corners.filter_map(|&corner| Some((corner, *polygon.get(corner.vertex as usize)?)))
    }

    /// The command that interprets a side's outline otherwise; `None` for a preset.
    pub fn interpret(&self, side: Side, interpretation: Interpretation) -> Option<Command> {
        self.reformed(side, |form| CurveForm { interpretation, ..form })
    }

    /// The command that makes a corner of a side's outline smooth, or the reverse.
    pub fn switch_corner(&self, side: Side, vertex: u32) -> Option<Command> {
        self.reformed(side, |mut form| {
            match form.switched.binary_search(&vertex) {
                Ok(at) => {
                    form.switched.remove(at);
                }
                Err(at) => form.switched.insert(at, vertex),
            }
            form
        })
    }

    fn reformed(&self, side: Side, change: impl FnOnce(CurveForm) -> CurveForm) -> Option<Command> {
        let outline = &self.session.domain(side).outline;
        let OutlineSpec::Points { form, .. } = outline else { return None };
        let outline = outline.clone().with_form(change(form.clone()));
        let state = self.session.side(side);
        Some(Command::ReshapeOutline { side, outline, interior: state.interior(), anchor: state.anchor() })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::PrepareSettings;
    use crate::geometry::SimplePolygon;
    use crate::mesh::Sizing;
    use crate::model::editing::{Change, Reshaping};
    use crate::outline::Sampling;
    use crate::session::Session;
    use crate::worker;

    const SIDE: Side = Side::Source;

    fn prepare(model: &mut Model) {
        while let requests @ [_, ..] = model.take_requests(f64::INFINITY).as_slice() {
            for (side, request) in requests {
                worker::run(request, &mut |generation, response| model.accept(*side, generation, response));
            }
            model.refresh(false);
        }
    }

    /// A half disk of 100 points, whose corners are the vertices 0 and 99.
    fn half_disk() -> Model {
        let point = |k: u32| DVec2::from_angle(std::f64::consts::PI * f64::from(k) / 99.0);
        let polygon = SimplePolygon::try_from((0..100).map(point).collect::<Vec<_>>()).unwrap();
        let settings = PrepareSettings::new(Sampling::Adaptive { target: Some(150) }, Sizing::Graded(0.3))
            .with_kernel(KernelMode::Integral);
        let outline = OutlineSpec::points(String::from("half disk"), polygon);
        let mut model = Model::new(Session::with([
            Command::SetOutline { side: SIDE, outline },
            Command::SetSettings { side: SIDE, settings },
        ]));
        model.update_ms = f64::INFINITY;
        prepare(&mut model);
        model
    }

    fn taken(model: &Model) -> (Interpretation, usize) {
        let interpreted = model.interpretation(SIDE).unwrap().taken.interpreted;
        (interpreted.interpretation, interpreted.corners)
    }

    fn switched(model: &Model) -> Vec<u32> {
        let OutlineSpec::Points { form, .. } = &model.session().domain(SIDE).outline else { panic!() };
        form.switched.clone()
    }

    #[test]
    fn corners_are_listed_and_switched_and_the_interpretation_is_chosen() {
        let mut model = half_disk();
        assert_eq!(taken(&model), (Interpretation::Smooth, 2));
        assert_eq!(model.corners(SIDE).map(|(corner, _)| corner.vertex).collect::<Vec<_>>(), [0, 99]);
        let before = model.session().clone();
        model.dispatch(model.switch_corner(SIDE, 99).unwrap(), 0.0);
        prepare(&mut model);
        assert_eq!(switched(&model), [99]);
        assert_eq!(model.corners(SIDE).filter(|(corner, _)| !corner.is_corner).count(), 1);
        model.dispatch(model.switch_corner(SIDE, 99).unwrap(), 0.0);
        prepare(&mut model);
        assert_eq!(model.session(), &before, "switched back");
        model.dispatch(model.interpret(SIDE, Interpretation::Polygon).unwrap(), 0.0);
        prepare(&mut model);
        assert_eq!(taken(&model), (Interpretation::Polygon, 100));
        assert_eq!(model.corners(SIDE).count(), 0);
        assert_eq!(model.interpretation(Side::Target), None, "a preset is its own curve");
    }

    #[test]
    fn reshaping_keeps_the_choice_and_the_switched_corners() {
        let mut model = half_disk();
        model.dispatch(model.interpret(SIDE, Interpretation::Smooth).unwrap(), 0.0);
        prepare(&mut model);
        model.dispatch(model.switch_corner(SIDE, 99).unwrap(), 0.0);
        prepare(&mut model);
        let mut reshaping = Reshaping::new(SIDE, &model);
        reshaping.change(Change::Mirror, &mut model).unwrap();
        prepare(&mut model);
        assert_eq!(model.interpretation(SIDE).unwrap().asked, Interpretation::Smooth);
        assert_eq!(switched(&model), [1], "the other way round from vertex 0");
    }
}
