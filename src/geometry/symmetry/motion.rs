//! Reflections and rotations with their derivatives, to be fitted to an outline.

use glam::DVec2;
use std::f64::consts::TAU;

/// A motion of the plane with two free parameters. The angle of a rotation is given.
#[derive(Debug, Clone, Copy)]
pub enum Motion {
    /// The reflection at the line of direction t = e^{i·angle} that runs through `offset`·n, where n = i t.
    Mirror { angle: f64, offset: f64 },
    /// The rotation by `angle` about `center`.
    Turn { center: DVec2, angle: f64 },
}

impl Motion {
    /// The image of p.
    pub fn image(self, p: DVec2) -> DVec2 {
        match self {
            Self::Mirror { angle, offset } => {
                let normal = DVec2::from_angle(angle).perp();
                p - 2.0 * (p.dot(normal) - offset) * normal
            }
            Self::Turn { center, angle } => center + DVec2::from_angle(angle).rotate(p - center),
        }
    }

    /// The derivatives of the image of p by the parameters: (angle, offset) or the center's coordinates.
    pub fn slopes(self, p: DVec2) -> [DVec2; 2] {
        match self {
            Self::Mirror { angle, offset } => {
                let along = DVec2::from_angle(angle);
                let normal = along.perp();
                [2.0 * p.dot(along) * normal + 2.0 * (p.dot(normal) - offset) * along, 2.0 * normal]
            }
            Self::Turn { angle, .. } => {
                let spoke = DVec2::from_angle(angle);
                [DVec2::X - spoke, DVec2::Y - spoke.perp()]
            }
        }
    }

    /// The motion whose parameters are larger by `step`.
    pub fn moved(self, step: DVec2) -> Self {
        match self {
            Self::Mirror { angle, offset } => Self::Mirror { angle: angle + step.x, offset: offset + step.y },
            Self::Turn { center, angle } => Self::Turn { center: center + step, angle },
        }
    }

    /// The motion and its powers except for the identity; of a turn by 2π/n these are n − 1.
    pub fn powers(self) -> impl Iterator<Item = Self> {
        let count = match self {
            Self::Turn { angle, .. } => (TAU / angle).round() as u32 - 1,
            Self::Mirror { .. } => 1,
        };
        (1..=count).map(move |power| match self {
            Self::Turn { center, angle } => Self::Turn { center, angle: f64::from(power) * angle },
            mirror @ Self::Mirror { .. } => mirror,
        })
    }
}
