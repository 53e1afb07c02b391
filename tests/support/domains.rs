//! Prepared presets.

use riemap::conformal::{PrepareSettings, PreparedSide, prepare};
use riemap::outline::Preset;
use std::sync::Arc;

pub fn domain(preset: Preset, settings: PrepareSettings) -> Arc<PreparedSide> {
    Arc::new(prepare(preset.outline().polygon(), &settings, &mut |_| ()).unwrap())
}
