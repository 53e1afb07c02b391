//! The compute shader's Cauchy–Green extension compared with the one in f64.

use super::support::*;
use glam::DVec2;
use riemap::conformal::{BoundaryValues, Contour};
use riemap::geometry::EdgeTree;
use riemap::mesh::{Sizing, mesh_domain};
use riemap::outline::{Preset, Sampling, sample};
use riemap::render::{CauchyGreenPass, Pattern, ViewportRenderer, sample_count};
use std::f64::consts::TAU;
use std::sync::mpsc;

fn pass(gpu: &Gpu) -> CauchyGreenPass {
    CauchyGreenPass::new(&gpu.0).unwrap_or_else(|| panic!("compute shaders are needed, which {} has not", gpu.2.name))
}

/// The images of `points` on the GPU, for several sets of values.
fn evaluated(
    gpu: &Gpu,
    pass: &CauchyGreenPass,
    contour: &[DVec2],
    points: &[DVec2],
    values: &[Vec<DVec2>],
) -> Vec<Vec<DVec2>> {
    let (device, queue, _) = gpu;
    let mut buffers = pass.buffers(device, queue, contour, points).unwrap();
    let mut evaluate = |values: &Vec<DVec2>| {
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        assert!(pass.evaluate(queue, &mut encoder, &mut buffers, values.iter().copied()));
        queue.submit([encoder.finish()]);
        let (sender, receiver) = mpsc::channel();
        buffers.read_back(device, queue, move |images| sender.send(images.unwrap()).unwrap());
        device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
        receiver.recv().unwrap()
    };
    values.iter().map(&mut evaluate).collect()
}

fn contour_of(preset: Preset, m: u32) -> Vec<DVec2> {
    let sampling = Sampling::Uniform { count: m, keep_corners: true };
    sample(preset.outline().polygon(), sampling).unwrap().points().to_vec()
}

fn extent(points: &[DVec2]) -> f64 {
    let low = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    (high - low).max_element()
}

fn inwards(contour: &[DVec2], k: usize) -> DVec2 {
    let m = contour.len();
    (contour[(k + 1) % m] - contour[k]).normalize().perp()
}

/// The boundary vertices, the vertices of a mesh, and points at distances of 1e-3 to 1e-8 of the extent
/// from every edge, also near its ends, and from every vertex.
fn points_of(contour: &[DVec2]) -> Vec<DVec2> {
    let m = contour.len();
    let mut points = mesh_domain(contour, Sizing::Graded(0.2)).unwrap().0.vertices().to_vec();
    let mut beside = Vec::new();
    for depth in [1e-3, 1e-4, 1e-5, 1e-6, 1e-8].map(|depth| depth * extent(contour)) {
        for k in 0..m {
            let edge = contour[(k + 1) % m] - contour[k];
            beside.extend([0.001, 0.37, 0.5, 0.999].map(|t| contour[k] + t * edge + depth * inwards(contour, k)));
            beside.push(contour[k] + depth * (inwards(contour, (k + m - 1) % m) + inwards(contour, k)).normalize());
        }
    }
    let tree = EdgeTree::new(contour);
    points.extend(beside.into_iter().filter(|&p| tree.signed_distance(p) > 0.0));
    points
}

/// A smooth closed curve with a random shape: a Fourier series whose terms decay as 1/j².
fn smooth(m: usize, seed: u64) -> Vec<DVec2> {
    let mut state = seed;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / f64::from(1 << 24) * TAU
    };
    let phases: Vec<[f64; 2]> = (0..12).map(|_| [random(), random()]).collect();
    let at = |s: f64| {
        let terms = phases.iter().zip(1..).map(|([a, b], j)| {
            let (j, angle) = (f64::from(j), TAU * f64::from(j) * s);
            DVec2::new((angle + a).cos(), (angle + b).sin()) / (j * j)
        });
        DVec2::new(1e3, -7e2) + 20.0 * terms.sum::<DVec2>()
    };
    (0..m).map(|k| at(k as f64 / m as f64)).collect()
}

/// Values that jump from vertex to vertex, as may occur early in a drag.
fn rough(m: usize) -> Vec<DVec2> {
    (0..m).map(|k| DVec2::from_angle(k as f64 * k as f64) * (1.0 + k as f64 / m as f64)).collect()
}

/// Outlines of presets, and a rotated square: long edges not aligned with a coordinate axis.
fn contours() -> Vec<(&'static str, Vec<DVec2>)> {
    let presets = [(Preset::Gingerbread, 500), (Preset::Star, 333), (Preset::VShape, 1000)];
    let sampled = presets.map(|(preset, m)| (preset.name(), contour_of(preset, m)));
    let turned = SQUARE.map(|p| DVec2::from_angle(0.3).rotate(p)).to_vec();
    sampled.into_iter().chain([("turned square", turned)]).collect()
}

#[test]
fn constants_are_exact_and_the_identity_holds_to_rounding() {
    let gpu = gpu();
    let pass = pass(gpu);
    let constant = DVec2::new(0.1, -1e5);
    for (name, contour) in contours() {
        let points = points_of(&contour);
        let values = [vec![constant; contour.len()], contour.clone()];
        let images = evaluated(gpu, &pass, &contour, &points, &values);
        assert!(images[0].iter().all(|&image| image == constant), "{}", name);
        let (error, at) = largest(&images[1], &points);
        println!("{}, {} points: identity off by {:.1e} of the extent", name, points.len(), error / extent(&contour));
        let tolerance = CauchyGreenPass::ERROR * extent(&contour);
        assert!(error < tolerance, "{}: {error:e} at {:?}", name, points[at]);
    }
}

fn largest(a: &[DVec2], b: &[DVec2]) -> (f64, usize) {
    assert_eq!(a.len(), b.len());
    let errors = a.iter().zip(b).map(|(a, b)| a.distance(*b));
    errors
        .zip(0..)
        .fold((0.0, 0), |worst, (error, k)| if error > worst.0 || error.is_nan() { (error, k) } else { worst })
}

#[test]
fn smooth_and_rough_values_have_the_f64_extension() {
    let gpu = gpu();
    let pass = pass(gpu);
    for (name, contour) in contours() {
        let points = points_of(&contour);
        let values = [smooth(contour.len(), 1), smooth(contour.len(), 2), rough(contour.len())];
        let images = evaluated(gpu, &pass, &contour, &points, &values);
        let exact = Contour::new(&contour);
        for (values, images) in values.iter().zip(&images) {
            let w = BoundaryValues::new(values.iter().copied());
            let expected: Vec<_> = points.iter().map(|&z| exact.evaluate(z, &w)).collect();
            let (error, at) = largest(images, &expected);
            let error = error / extent(values);
            println!("{}, {} points: off by {error:.1e} of the extent", name, points.len());
            assert!(
                error < CauchyGreenPass::ERROR,
                "{}, point {at} {:?}: {:?}, f64 {:?}",
                name,
                points[at],
                images[at],
                expected[at]
            );
        }
    }
}

#[test]
fn the_mesh_is_drawn_from_the_images_without_reading_them_back() {
    let gpu = gpu();
    let pass = pass(gpu);
    let (device, queue, _) = gpu;
    let format = wgpu::TextureFormat::Rgba8Unorm;
    // linear values on a polygon are their own extension; a rotation by 90° is holomorphic
    let moved = SQUARE.map(|p| 0.5 * p.perp() + DVec2::new(0.75, -0.5));
    let mut buffers = pass.buffers(device, queue, &SQUARE, &SQUARE).unwrap();
    let mut three = pass.buffers(device, queue, &SQUARE, &SQUARE[..3]).unwrap();
    let style = style(Pattern::Checker, 8.0);
    for positions in [true, false] {
        let mut renderer = ViewportRenderer::new(device, queue, format, 1, sample_count(device));
        assert!(renderer.set_mesh(device, queue, 0, &square(style).geometry));
        let before = painted(gpu, &mut renderer, format, &style);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        assert!(pass.evaluate(queue, &mut encoder, &mut buffers, moved));
        assert!(pass.evaluate(queue, &mut encoder, &mut three, moved));
        assert!(!pass.evaluate(queue, &mut encoder, &mut three, SQUARE.into_iter().skip(1)), "three values");
        let copied = if positions {
            assert!(
                !renderer.copy_positions(&mut encoder, 0, &three)
                    && !renderer.copy_positions(&mut encoder, 1, &buffers)
            );
            renderer.copy_positions(&mut encoder, 0, &buffers)
        } else {
            assert!(!renderer.copy_texture_coordinates(&mut encoder, 0, &three));
            renderer.copy_texture_coordinates(&mut encoder, 0, &buffers)
        };
        assert!(copied);
        queue.submit([encoder.finish()]);
        let computed = painted(gpu, &mut renderer, format, &style);
        assert!(if positions {
            renderer.set_positions(queue, 0, &moved)
        } else {
            renderer.set_texture_coordinates(queue, 0, &moved)
        });
        let uploaded = painted(gpu, &mut renderer, format, &style);
        assert_ne!(computed, before);
        // the images may differ by an ulp of f32, which is a step of 8-bit coverage at an edge
        let difference = computed.iter().zip(uploaded.iter()).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
        assert!(difference <= 2, "positions: {positions}, off by {difference}");
    }
}

/// `cargo test --release --test render -- --ignored --nocapture a_hundred_thousand`
#[test]
#[ignore = "a measurement: prints the time on this machine's adapter"]
fn a_hundred_thousand_points_and_a_thousand_samples() {
    let gpu = gpu();
    let pass = pass(gpu);
    let (device, queue, info) = gpu;
    let contour = contour_of(Preset::Gingerbread, 1000);
    let mut points = mesh_domain(&contour, Sizing::Graded(0.05)).unwrap().0.vertices().to_vec();
    let (low, high) =
        (contour.iter().copied().reduce(DVec2::min).unwrap(), contour.iter().copied().reduce(DVec2::max).unwrap());
    let tree = EdgeTree::new(&contour);
    // points of a golden-ratio lattice in the bounding box, until enough are inside
    let lattice = (0..)
        .map(|k| low + (high - low) * DVec2::new(f64::from(k) / 400_000.0, (f64::from(k) * 0.618_033_988_7).fract()));
    points.truncate(100_000);
    let missing = 100_000 - points.len();
    points.extend(lattice.filter(|&p| tree.signed_distance(p) > 0.0).take(missing));
    let mut buffers = pass.buffers(device, queue, &contour, &points).unwrap();
    let values = smooth(contour.len(), 1);
    let mut times: Vec<f64> = (0..11)
        .map(|_| {
            let start = std::time::Instant::now();
            let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            assert!(pass.evaluate(queue, &mut encoder, &mut buffers, values.iter().copied()));
            queue.submit([encoder.finish()]);
            device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    println!(
        "{} points, {} samples on {} ({:?}): {:.2} ms, at best {:.2}",
        points.len(),
        contour.len(),
        info.name,
        info.device_type,
        times[5],
        times[0]
    );
}
