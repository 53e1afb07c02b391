//! Kernel and solver, the settings that outlines and surfaces have in common: one path to change them on both sides.

use crate::conformal::{HarmonicTable, KernelMode, Memory, PrepareSettings, Side, TableError};
use crate::laplace::SolverKind;
use crate::model::Model;
use crate::session::{Command, SurfaceSpec};

/// The method by which a side is prepared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Method {
    /// How the Poisson kernel is computed.
    pub kernel: KernelMode,
    /// How linear systems are solved.
    pub solver: SolverKind,
}

impl Method {
    fn of(PrepareSettings { kernel, solver, .. }: PrepareSettings) -> Self {
        Self { kernel, solver }
    }
}

impl Model {
    /// The requested method. Both sides have one; where a session differs, that of the source's outline.
    pub fn method(&self) -> Method {
        Method::of(self.side(Side::Source).wanted().settings)
    }

    /// The commands that change the method of everything that is requested: of both outlines, also behind a surface, and
    /// of the surfaces that are shown, whose kernels are by adjoint solves where the outlines' are by the boundary integral.
    pub fn set_method(&self, change: impl Fn(Method) -> Method) -> Vec<Command> {
        let of_outline = |side: Side| {
            let settings = self.side(side).wanted().settings;
            let Method { kernel, solver } = change(Method::of(settings));
            Command::SetSettings { side, settings: PrepareSettings { kernel, solver, ..settings } }
        };
        let Method { kernel, solver } = change(self.method());
        // a surface has no curve
        let of_surfaces = if kernel == KernelMode::Integral { KernelMode::Adjoint } else { kernel };
        let of_surface = |side: Side| {
            let mut surface: SurfaceSpec = self.surface_settings(side)?.clone();
            (surface.settings.kernel, surface.settings.solver) = (of_surfaces, solver);
            Some(Command::RefineSurface { side, surface })
        };
        Side::BOTH.into_iter().map(of_outline).chain(Side::BOTH.into_iter().filter_map(of_surface)).collect()
    }

    /// Why a kernel is not available for what is prepared: the table of Ψ does not fit into memory.
    pub fn refused_kernel(&self, kernel: KernelMode) -> Option<TableError> {
        let outlines = Side::BOTH.into_iter().filter_map(|side| self.side(side).prepared());
        let surfaces = Side::BOTH.into_iter().filter_map(|side| self.surface(side)?.0.prepared());
        outlines.chain(surfaces).filter(|_| kernel == KernelMode::Table).find_map(|side| {
            HarmonicTable::check(side.interior_count(), side.boundary_count(), Memory::default()).err()
        })
    }
}
