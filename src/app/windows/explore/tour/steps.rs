//! The steps of the guided tour: six sessions with a few sentences each, and what each does by itself.

use crate::app::windows::explore::gallery::crowding;
use crate::conformal::{Direction, Side};
use crate::family::Path;
use crate::language::{Label, key};
use crate::outline::Preset;
use crate::session::{Command, OutlineSpec, Session, SurfaceShape, SurfaceSpec, TextureKind};
use crate::surface::SurfacePreset;
use std::sync::LazyLock;

/// One step of the tour.
pub struct Step {
    pub title: Label,
    /// The sentences: what there is to see and to try.
    pub text: Label,
    /// The session that is shown.
    pub session: Session,
    /// Whether the random walks run.
    pub walks: bool,
    /// The points that move one after another, each once around.
    pub motions: &'static [Path],
    /// Whether a circle with a cross is carried along.
    pub probes: bool,
}

/// All steps, in order; built once.
pub fn steps() -> &'static [Step] {
    static STEPS: LazyLock<Vec<Step>> = LazyLock::new(make_steps);
    &STEPS
}

fn make_steps() -> Vec<Step> {
    let step = |title, text, session| Step { title, text, session, walks: false, motions: &[], probes: false };
    let polar = Session::with([Command::SetTexture(TextureKind::Conformal)]);
    vec![
        Step {
            motions: &[Path::SourcePoint],
            ..step(key::map_between_two_shapes(), key::map_between_two_shapes_about(), cells(12.0))
        },
        Step { probes: true, ..step(key::angles_stay(), key::angles_stay_about(), cells(24.0)) },
        Step {
            motions: &[Path::SourcePoint, Path::TargetPoint, Path::Boundary],
            ..step(key::three_freedoms(), key::three_freedoms_about(), polar)
        },
        Step { walks: true, ..step(key::harmonic_measure(), key::harmonic_measure_about(), measured()) },
        step(key::crowding(), key::tour_crowding_about(), crowding()),
        Step { motions: &[Path::Boundary], ..step(key::surfaces(), key::surfaces_about(), solid()) },
    ]
}

fn cells(across: f64) -> Session {
    Session::with([Command::SetTextureScale(across)])
}

fn measured() -> Session {
    Session::with([
        Command::SetPlots(true),
        Command::SetDirection(Direction::Backward),
        Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::Hand) },
        Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(Preset::Disk) },
    ])
}

fn solid() -> Session {
    let surface = SurfaceSpec { shape: SurfaceShape::preset(SurfacePreset::AnimalHead), ..SurfaceSpec::default() };
    Session::with([Command::SetSurface { side: Side::Target, surface }])
}
