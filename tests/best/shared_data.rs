//! Real meshes.

use super::support::data::shared;
use super::through_disk::{Disk, distortion, point_of};
use super::{AS_GOOD, best, defaults, measured, outline};
use riemap::conformal::{Constraints, Direction, PerSide, PreparedSide, SurfaceSettings, prepare_surface};
use riemap::optimization::Criterion;
use riemap::outline::Preset;
use riemap::surface::{SurfaceMesh, read_surface};
use std::sync::Arc;

fn prepared(name: &str) -> Arc<PreparedSide> {
    let surface = read_surface(name, &std::fs::read(shared(&format!("meshes/{name}"))).unwrap()).unwrap();
    let mesh = SurfaceMesh::repaired(&surface).unwrap();
    Arc::new(prepare_surface(mesh, SurfaceSettings::default(), &mut |_| ()).unwrap())
}

#[test]
#[ignore = "needs ../shared/data"]
fn meshes_over_the_disk_are_mapped_as_well_as_by_the_best_moebius_transformation() {
    for name in ["cowhead.obj", "face.obj"] {
        let surface = prepared(name);
        let mesh = surface.surface().unwrap().mesh();
        let (baseline, a) = Disk::of(&surface).best(|images| distortion(mesh, images));
        let sides = PerSide::new(outline(Preset::Disk), Arc::clone(&surface));
        let found = best(&sides, Criterion::Area, &defaults(&sides), Direction::Backward);
        println!("{name}, {} vertices: {:.6}, through the disk {baseline:.6}", mesh.vertices().len(), found.after);
        assert!(found.after <= baseline * AS_GOOD && found.after <= found.before);
        // the same transformation, measured as maps are: no error of meshes in between
        let at = Constraints::new((point_of(a, &sides.source), 0.0), (surface.default_point(), 0.0));
        let same = measured(&sides, &Criterion::Area, &at, Direction::Backward);
        println!("{name}: {same:.6}, measured on the map");
        assert!(same.is_finite() && found.after <= same * AS_GOOD);
    }
}
