//! The session that is asked for: what is kept of a session whose shapes are still being prepared.

use crate::conformal::Side;
use crate::model::Model;
use crate::model::side::{ModelSide, Next};
use crate::session::{Command, Session, SidePoints, SurfaceState};

impl Model {
    /// The session that will be shown once everything that was requested is prepared: [`Model::session`] with the
    /// outlines, settings and surfaces in preparation and their points. A file that is still being read is not in it, and
    /// a preparation may fail.
    pub fn requested(&self) -> Session {
        let session = Side::BOTH.into_iter().fold(self.session.clone(), |session, side| {
            let session = session.and(self.outline_in_preparation(side));
            session.and(self.shape_in_preparation(side))
        });
        session.and(self.pinned.incoming().cloned().map(|pins| Command::SetPins(Some(pins))))
    }

    /// The commands that bring the outline in preparation, with its settings and points.
    fn outline_in_preparation(&self, side: Side) -> Vec<Command> {
        let ModelSide { outline: preparation, incoming_points, .. } = &self.sides[side];
        if !preparation.is_busy() {
            return Vec::new();
        }
        let spec = preparation.wanted();
        let mut commands = vec![Command::SetSettings { side, settings: spec.settings }];
        if spec.outline != self.session.domain(side).outline {
            let outline = spec.outline.clone();
            let (interior, anchor) = match preparation.wanted_points() {
                Some(reshaped) => (reshaped.interior, reshaped.anchor),
                None => (None, outline.first_anchor()),
            };
            if preparation.wanted_points().is_none() && self.session.surface(side).is_none() {
                commands.push(Command::SetPins(None));
                commands.extend(without_region(side));
            }
            commands.push(Command::ReshapeOutline { side, outline, interior, anchor });
        }
        commands.extend(incoming_points.map(|points: SidePoints| Command::PlacePoints { side, points }));
        commands
    }

    /// The commands that bring the surface in preparation, or remove the one that an outline replaces.
    fn shape_in_preparation(&self, side: Side) -> Vec<Command> {
        let ModelSide { surface, next, .. } = &self.sides[side];
        let of_state = |state: &SurfaceState| {
            vec![
                Command::SetSurface { side, surface: state.spec.clone() },
                Command::SetHoles { side, holes: state.holes() },
                Command::PlacePoints { side, points: state.points() },
            ]
        };
        match next {
            Next::Outline => std::iter::once(Command::CloseSurface(side)).chain(without_region(side)).collect(),
            Next::Surface(state) => of_state(state),
            Next::Same if surface.preparation.is_busy() => {
                let Some(wanted) = surface.preparation.wanted().cloned() else { return Vec::new() };
                let shown = self.session.surface(side);
                let is_another = shown.is_none_or(|shown| !shown.spec.shape.is_like(&wanted.shape));
                let region = without_region(side).filter(|_| is_another);
                std::iter::once(Command::SetSurface { side, surface: wanted }).chain(region).collect()
            }
            Next::Same => Vec::new(),
        }
    }
}

/// What drops the region painted on the source that another shape replaces.
fn without_region(side: Side) -> Option<Command> {
    (side == Side::Source).then(|| Command::SetRegion(Vec::new()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::surface_tests::settle;
    use crate::outline::Preset;
    use crate::session::{OutlineSpec, SurfaceShape, SurfaceSpec};
    use crate::surface::SurfacePreset;

    fn prepared() -> Model {
        let mut model = Model::new(Session::default());
        settle(&mut model);
        model
    }

    fn on_surface() -> Session {
        let surface = SurfaceSpec { shape: SurfaceShape::preset(SurfacePreset::AnimalHead), ..SurfaceSpec::default() };
        Session::with([Command::SetSurface { side: Side::Target, surface }])
    }

    #[test]
    fn a_surface_that_is_not_prepared_yet_is_asked_for() {
        let session = on_surface();
        let model = Model::new(session.clone());
        assert_eq!(model.session().surface(Side::Target), None, "it is not shown yet");
        assert_eq!(model.requested(), session);
    }

    #[test]
    fn an_opened_session_is_asked_for_with_its_points_before_it_is_prepared() {
        let mut model = prepared();
        let outline = OutlineSpec::Preset(Preset::Star);
        let star = Command::SetOutline { side: Side::Source, outline: outline.clone() };
        let moved = Command::MoveAnchor { side: Side::Source, fraction: 0.3125 };
        for session in [Session::with([star.clone(), moved]), on_surface()] {
            model.dispatch(Command::Open(Box::new(session.clone())), 0.0);
            assert_eq!(model.requested(), session);
        }
        let mut model = prepared();
        let before = model.session().clone();
        assert_eq!(model.requested(), before, "nothing is being prepared");
        model.dispatch(star.clone(), 0.0);
        assert_eq!(model.requested(), before.and([star]));
    }
}
