//! Surfaces in space: positions of patterns, depth, edges, light, handles.

use super::support::*;
use glam::{DVec2, DVec3};
use image::{Rgba, RgbaImage};
use riemap::render::{
    BoundingSphere, CellCode, CellStyle, ColourMap, Detail, OrbitCamera, Pace, Pattern, REFINED_AFTER,
    SceneDescription, ScenePicture, SceneSurface, SpaceFrame, StrokeStyle, SurfaceGeometry, SurfaceHandle,
    TextureStyle, ViewportRenderer, render_scene_with,
};
use riemap::surface::{SurfaceMesh, SurfacePreset};

const SIZE: u32 = 240;
const WIRE: StrokeStyle = StrokeStyle { colour: [1.0, 0.0, 0.0, 1.0], width_px: 3.0 };
const LOOP: StrokeStyle = StrokeStyle { colour: [0.0, 1.0, 0.0, 1.0], width_px: 5.0 };

/// Squares facing the camera, which is on the z axis, given by their lower left and upper right corners and z.
struct Squares {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    coordinates: Vec<DVec2>,
    boundary_count: u32,
}

impl Squares {
    /// The corners of the first square are the boundary; square k has the texture of column k of `count`.
    fn new(squares: &[(DVec2, DVec2, f64)]) -> Self {
        let corners = |&(low, high, z): &(DVec2, DVec2, f64)| {
            [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)].map(|p| p.extend(z))
        };
        let count = squares.len();
        let column = |k: usize| DVec2::new((2 * k + 1) as f64 / count as f64 - 1.0, 0.0);
        Self {
            positions: squares.iter().flat_map(corners).collect(),
            triangles: (0..count as u32).flat_map(|k| [[0, 1, 2], [0, 2, 3]].map(|t| t.map(|v| v + 4 * k))).collect(),
            coordinates: (0..count).flat_map(|k| [column(k); 4]).collect(),
            boundary_count: 4,
        }
    }

    fn scene(&self) -> SceneSurface<'_> {
        SceneSurface {
            geometry: SurfaceGeometry {
                positions: &self.positions,
                triangles: &self.triangles,
                boundary_count: self.boundary_count,
            },
            texture_coordinates: &self.coordinates,
            codes: &[],
            cells: None,
            camera: camera(DVec3::Z),
            style: style(Pattern::Image, 1.0),
            stroke: Some(LOOP),
            handles: &[],
        }
    }
}

fn camera(towards_eye: DVec3) -> OrbitCamera {
    OrbitCamera::new(BoundingSphere { center: DVec3::ZERO, radius: 1.6 }, towards_eye, DVec3::Y, 1.0)
}

/// The pixel at which a point is seen.
fn pixel(camera: &OrbitCamera, place: [f64; 3]) -> [u32; 2] {
    let at = camera.to_screen(DVec3::from_array(place), DVec2::splat(f64::from(SIZE))).unwrap();
    [at.x as u32, at.y as u32]
}

/// Wide columns of uniform colors over [−1, 1]².
fn columns(colours: &[[u8; 4]]) -> RgbaImage {
    let count = colours.len() as u32;
    RgbaImage::from_fn(64 * count, 64 * count, |x, _| Rgba(colours[(x / 64) as usize]))
}

fn picture(gpu: &Gpu, surface: &SceneSurface, image: Option<&RgbaImage>) -> RgbaImage {
    row(gpu, &[surface.clone().into()], image)
}

/// The pictures side by side, each a square of [`SIZE`].
fn row(gpu: &Gpu, pictures: &[ScenePicture], image: Option<&RgbaImage>) -> RgbaImage {
    let scene = SceneDescription { pictures, background: BACKGROUND, image, margin_px: 0.0 };
    render_scene_with(&gpu.0, &gpu.1, &scene, [SIZE * pictures.len() as u32, SIZE]).unwrap()
}

const ORANGE: [u8; 4] = [230, 150, 60, 255];
const BLUE: [u8; 4] = [60, 110, 200, 255];

/// A large square, and a small one in front of it, with orange and blue texture.
fn one_before_the_other() -> Squares {
    Squares::new(&[(-DVec2::ONE, DVec2::ONE, -0.5), (DVec2::splat(-0.4), DVec2::splat(0.4), 0.5)])
}

#[test]
fn the_nearer_face_hides_the_farther_in_either_order_and_flat_colours_are_as_asked() {
    let gpu = gpu();
    let image = columns(&[ORANGE, BLUE]);
    let mut squares = one_before_the_other();
    for _ in 0..2 {
        let shown = picture(gpu, &squares.scene(), Some(&image));
        let camera = camera(DVec3::Z);
        // the sheen adds a thousandth of the light; conversion from linear to encoded in 8 bits
        assert_pixel(&shown, pixel(&camera, [0.1, -0.2, 0.5]), BLUE, 2, "in front");
        assert_pixel(&shown, pixel(&camera, [-0.8, 0.8, -0.5]), ORANGE, 2, "behind");
        assert_pixel(&shown, [2, 2], bytes(BACKGROUND), 1, "background");
        squares.triangles.rotate_left(2);
    }
}

#[test]
fn a_surface_of_any_size_is_drawn_as_one_of_the_usual_size() {
    let gpu = gpu();
    let image = columns(&[ORANGE, BLUE]);
    let usual = one_before_the_other();
    let handle =
        SurfaceHandle { position: DVec3::new(0.3, 0.2, 0.5), hidden: false, colour: LOOP.colour, radius_px: 9.0 };
    let cells = CellStyle { map: None, wire: Some(WIRE), marks: false, pixels_per_point: 1.0 };
    let towards_eye = DVec3::new(0.3, 0.4, 1.0);
    let shown = |size: f64| {
        let positions: Vec<_> = usual.positions.iter().map(|&p| size * p).collect();
        let scene = BoundingSphere { center: DVec3::ZERO, radius: 1.6 * size };
        let handles = [SurfaceHandle { position: size * handle.position, ..handle }];
        let surface = SceneSurface {
            geometry: SurfaceGeometry { positions: &positions, triangles: &usual.triangles, boundary_count: 4 },
            camera: OrbitCamera::new(scene, towards_eye, DVec3::Y, 1.0),
            cells: Some(cells),
            handles: &handles,
            ..usual.scene()
        };
        picture(gpu, &surface, Some(&image))
    };
    let expected = shown(1.0);
    for exponent in [-330, -130, 127, 133, 332] {
        let differing = shown(2_f64.powi(exponent)).pixels().zip(expected.pixels()).filter(|(p, q)| p != q).count();
        assert_eq!(differing, 0, "2^{exponent}");
    }
}

#[test]
fn back_faces_have_three_fifths_of_the_light() {
    let gpu = gpu();
    let image = columns(&[ORANGE]);
    let mut square = Squares::new(&[(-DVec2::ONE, DVec2::ONE, 0.0)]);
    square.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    let shown = picture(gpu, &square.scene(), Some(&image));
    let back = shown.get_pixel(SIZE / 2 + 9, SIZE / 2).0;
    for (actual, front) in back.into_iter().zip(ORANGE).take(3) {
        let share = linear(actual) / linear(front);
        assert!((share - 0.6).abs() < 0.03, "{actual} of {front}: {share}");
    }
}

#[test]
fn the_loop_is_drawn_where_nothing_is_before_it() {
    let gpu = gpu();
    // the right side of the small square covers the middle of the large one's right side
    let squares = Squares::new(&[(-DVec2::ONE, DVec2::ONE, -0.5), (DVec2::new(0.2, -0.4), DVec2::new(0.9, 0.4), 0.5)]);
    let shown = picture(gpu, &squares.scene(), Some(&columns(&[ORANGE, BLUE])));
    let camera = camera(DVec3::Z);
    let green = bytes(LOOP.colour);
    assert_pixel(&shown, pixel(&camera, [1.0, 0.8, -0.5]), green, 1, "free side");
    assert_pixel(&shown, pixel(&camera, [-0.3, -1.0, -0.5]), green, 1, "lower side");
    assert_pixel(&shown, pixel(&camera, [1.0, 0.1, -0.5]), BLUE, 2, "behind the small square");
}

#[test]
fn edges_behind_a_face_are_hidden() {
    let gpu = gpu();
    let mut squares = Squares::new(&[
        (-DVec2::ONE, DVec2::new(0.1, 1.0), -0.5),
        (DVec2::new(0.1, -1.0), DVec2::ONE, -0.5),
        (DVec2::splat(-0.5), DVec2::splat(0.5), 0.5),
    ]);
    squares.boundary_count = 0;
    let mut scene = squares.scene();
    scene.cells = Some(CellStyle { map: None, wire: Some(WIRE), marks: false, pixels_per_point: 1.0 });
    let shown = picture(gpu, &scene, Some(&columns(&[ORANGE, ORANGE, BLUE])));
    let camera = camera(DVec3::Z);
    let red = bytes(WIRE.colour);
    assert_pixel(&shown, pixel(&camera, [0.1, 0.9, -0.5]), red, 1, "an edge in the open");
    assert_pixel(&shown, pixel(&camera, [0.0, 0.0, 0.5]), red, 1, "the diagonal of the face in front");
    assert_pixel(&shown, pixel(&camera, [0.1, -0.35, -0.5]), BLUE, 2, "the same edge behind a face");
}

#[test]
fn triangles_that_face_the_eye_have_the_colours_of_their_values() {
    let gpu = gpu();
    let square = Squares::new(&[(-DVec2::ONE, DVec2::ONE, 0.0)]);
    for map in [ColourMap::Cividis, ColourMap::Diverging] {
        let codes = [CellCode::at(0.3), CellCode::at(0.9)];
        let mut scene = square.scene();
        scene.codes = &codes;
        scene.cells = Some(CellStyle { map: Some(map), wire: None, marks: false, pixels_per_point: 1.0 });
        let shown = picture(gpu, &scene, None);
        let camera = camera(DVec3::Z);
        assert_pixel(&shown, pixel(&camera, [0.5, -0.5, 0.0]), bytes(map.at(0.3)), 3, "below the diagonal");
        assert_pixel(&shown, pixel(&camera, [-0.5, 0.5, 0.0]), bytes(map.at(0.9)), 3, "above the diagonal");
    }
}

#[test]
fn handles_are_seen_where_their_points_are_and_are_fainter_behind_the_surface() {
    let gpu = gpu();
    let square = Squares::new(&[(-DVec2::ONE, DVec2::ONE, 0.0)]);
    let at = |position: [f64; 3], hidden| SurfaceHandle {
        position: DVec3::from_array(position),
        hidden,
        colour: MAGENTA,
        radius_px: 9.0,
    };
    let handles = [at([0.4, 0.3, 0.0], false), at([-0.4, 0.3, -0.5], true), at([0.0, 0.0, 99.0], false)];
    let mut scene = square.scene();
    scene.handles = &handles;
    let shown = picture(gpu, &scene, Some(&columns(&[BLUE])));
    let camera = camera(DVec3::Z);
    assert_pixel(&shown, pixel(&camera, [0.4, 0.3, 0.0]), bytes(MAGENTA), 1, "before the surface");
    assert_pixel(&shown, pixel(&camera, [0.0, -0.1, 0.0]), BLUE, 2, "the handle behind the eye");
    let [x, y] = pixel(&camera, [-0.4, 0.3, -0.5]);
    let red = linear(shown.get_pixel(x, y).0[0]);
    let expected = linear(BLUE[0]) + 0.35 * (linear(bytes(MAGENTA)[0]) - linear(BLUE[0]));
    assert!((red - expected).abs() < 0.02, "{red} should be {expected}");
}

/// The upper half of the sphere with its stereographic images in the unit disk.
fn hemisphere() -> (SurfaceMesh, Vec<DVec2>) {
    let mesh = SurfaceMesh::new(&SurfacePreset::Hemisphere.surface(160).unwrap()).unwrap();
    let images = mesh.mesh().vertices().iter().map(|p| p.truncate() / (1.0 + p.z)).collect();
    (mesh, images)
}

fn hemisphere_scene<'a>(mesh: &'a SurfaceMesh, images: &'a [DVec2], towards_eye: DVec3) -> SceneSurface<'a> {
    let mesh = mesh.mesh();
    SceneSurface {
        geometry: SurfaceGeometry {
            positions: mesh.vertices(),
            triangles: mesh.triangles(),
            boundary_count: mesh.boundary_count(),
        },
        texture_coordinates: images,
        codes: &[],
        cells: None,
        camera: camera(towards_eye),
        style: TextureStyle { dark: true, ..style(Pattern::Checker, 8.0) },
        stroke: None,
        handles: &[],
    }
}

#[test]
fn a_hemisphere_carries_the_pattern_of_its_stereographic_image() {
    let gpu = gpu();
    let (mesh, images) = hemisphere();
    let towards_eye = DVec3::new(0.3, -0.8, 0.9).normalize();
    let scene = hemisphere_scene(&mesh, &images, towards_eye);
    let shown = picture(gpu, &scene, None);
    let mut seen = [0; 2];
    for (i, j) in (-4..4).flat_map(|i| (-4..4).map(move |j| (i, j))) {
        // the middle of a cell with side 1/4
        let z = DVec2::new(f64::from(i) + 0.5, f64::from(j) + 0.5) / 4.0;
        let normal = (2.0 * z).extend(1.0 - z.length_squared()) / (1.0 + z.length_squared());
        if z.length() > 0.85 || normal.dot(towards_eye) < 0.5 {
            continue;
        }
        let [x, y] = pixel(&scene.camera, normal.to_array());
        let [r, g, b, _] = shown.get_pixel(x, y).0;
        let light = 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
        let is_paper = (i + j) % 2 == 0;
        seen[usize::from(is_paper)] += 1;
        // paper reflects 0.85, the hues 0.11 to 0.19; the light scales this by 0.45 to 1.1
        assert_eq!(light > 0.28, is_paper, "cell ({i}, {j}) at ({x}, {y}): {light}");
    }
    assert!(seen[0] >= 5 && seen[1] >= 5, "{seen:?}");
}

#[test]
fn through_the_open_side_of_a_hemisphere_its_inside_is_seen_darker() {
    let gpu = gpu();
    let (mesh, images) = hemisphere();
    let image = columns(&[ORANGE]);
    let red = |towards_eye: DVec3| {
        let mut scene = hemisphere_scene(&mesh, &images, towards_eye);
        scene.style.pattern = Pattern::Image;
        linear(picture(gpu, &scene, Some(&image)).get_pixel(SIZE / 2, SIZE / 2).0[0])
    };
    let (outside, inside) = (red(DVec3::Z), red(-DVec3::Z));
    assert!((inside / outside - 0.6).abs() < 0.03, "{inside} inside, {outside} outside");
}

/// A frame of the live renderer with the scene.
fn live_frame_of(scene: &SceneSurface) -> SpaceFrame {
    SpaceFrame {
        size_px: [64, 64],
        camera: scene.camera,
        style: scene.style,
        cells: None,
        stroke: LOOP,
        background: BACKGROUND,
    }
}

/// Records and paints the next frame of the surface; returns its detail if anything was recorded.
fn recorded(gpu: &Gpu, renderer: &mut ViewportRenderer, frame: &SpaceFrame, pace: Pace) -> Option<Detail> {
    let (device, queue, _) = gpu;
    let prepare = |renderer: &mut ViewportRenderer, encoder: &mut wgpu::CommandEncoder| {
        renderer.prepare_surface(device, queue, encoder, 0, frame, pace)
    };
    one_frame(gpu, renderer, wgpu::TextureFormat::Rgba8Unorm, prepare, |renderer, pass| renderer.paint_surface(pass, 0))
        .0
}

#[test]
fn an_unchanged_surface_is_not_recorded_and_every_change_is() {
    let gpu = gpu();
    let (device, queue, _) = gpu;
    let mut renderer = ViewportRenderer::new(device, queue, wgpu::TextureFormat::Rgba8Unorm, 1, 1);
    let squares = Squares::new(&[(-DVec2::ONE, DVec2::ONE, 0.0)]);
    let scene = squares.scene();
    let frame = live_frame_of(&scene);
    assert_eq!(recorded(gpu, &mut renderer, &frame, Pace::Full), None, "there is no surface");
    let handle = SurfaceHandle { position: DVec3::ZERO, hidden: false, colour: GREEN, radius_px: 4.0 };
    let mut codes = vec![CellCode::FLIPPED; 2];
    let mut changes: Vec<Change> = vec![
        ("set_surface", Box::new(|r| r.set_surface(device, queue, 0, &scene.geometry))),
        ("set_surface_coordinates", Box::new(|r| r.set_surface_coordinates(queue, 0, &squares.coordinates))),
        ("set_surface_codes", Box::new(|r| r.set_surface_codes(queue, 0, &mut codes))),
        ("set_surface_handles", Box::new(|r| (r.set_surface_handles(0, &[handle]), true).1)),
        ("set_image", Box::new(|r| r.set_image(device, queue, &[0; 16], 2, 2).is_ok())),
    ];
    for (name, change) in &mut changes {
        assert!(change(&mut renderer), "{name}");
        assert_eq!(recorded(gpu, &mut renderer, &frame, Pace::Full), Some(Detail::Full), "{name}");
        assert_eq!(recorded(gpu, &mut renderer, &frame, Pace::Full), None, "after {name}");
    }
    let turned = SpaceFrame { camera: camera(DVec3::new(1.0, 0.0, 1.0)), ..frame };
    let at = |now| Pace::CoarseFirst { now };
    assert_eq!(recorded(gpu, &mut renderer, &turned, at(1.0)), Some(Detail::Coarse));
    assert!(renderer.draws_surface_coarsely(0));
    assert_eq!(recorded(gpu, &mut renderer, &turned, at(1.0 + 2.0 * REFINED_AFTER)), Some(Detail::Full));
    assert!(!renderer.draws_surface_coarsely(0));
}

#[test]
fn a_surface_looks_the_same_whether_its_drawing_was_rehearsed_or_not() {
    let gpu = gpu();
    let (device, queue, _) = gpu;
    let (mesh, images) = hemisphere();
    let scene = hemisphere_scene(&mesh, &images, DVec3::new(0.3, -0.8, 0.9).normalize());
    let frame = live_frame_of(&scene);
    let painted = |rehearses: bool| {
        let mut renderer = ViewportRenderer::new(device, queue, wgpu::TextureFormat::Rgba8Unorm, 1, 1);
        if rehearses {
            renderer.rehearse_surface(device, queue);
        }
        assert!(renderer.set_surface(device, queue, 0, &scene.geometry));
        assert!(renderer.set_surface_coordinates(queue, 0, &images));
        let prepare = |renderer: &mut ViewportRenderer, encoder: &mut wgpu::CommandEncoder| {
            renderer.prepare_surface(device, queue, encoder, 0, &frame, Pace::Full)
        };
        one_frame(gpu, &mut renderer, wgpu::TextureFormat::Rgba8Unorm, prepare, |renderer, pass| {
            renderer.paint_surface(pass, 0);
        })
        .1
    };
    let (at_once, rehearsed) = (painted(false), painted(true));
    assert!(at_once.pixels().any(|pixel| pixel.0 == bytes(LOOP.colour)), "something is drawn");
    assert!(at_once == rehearsed);
}

#[test]
fn two_surfaces_and_a_plane_side_by_side_are_as_each_alone() {
    let gpu = gpu();
    let (mesh, images) = hemisphere();
    let eyes = [DVec3::new(0.3, -0.8, 0.9), DVec3::new(-0.6, 0.2, 0.7)].map(DVec3::normalize);
    let codes = vec![CellCode::at(0.4); mesh.mesh().triangles().len()];
    let mut surfaces = eyes.map(|eye| hemisphere_scene(&mesh, &images, eye));
    surfaces[1].codes = &codes;
    surfaces[1].cells =
        Some(CellStyle { map: Some(ColourMap::Cividis), wire: Some(WIRE), marks: false, pixels_per_point: 1.0 });
    let plane = ScenePicture::from(square(style(Pattern::Checker, 8.0)));
    let pictures = [surfaces[0].clone().into(), plane, surfaces[1].clone().into()];
    let together = row(gpu, &pictures, None);
    for (k, one) in pictures.into_iter().enumerate() {
        let alone = row(gpu, &[one], None);
        let part = image::imageops::crop_imm(&together, SIZE * k as u32, 0, SIZE, SIZE).to_image();
        assert!(part == alone, "picture {k} is another one beside others");
    }
}
