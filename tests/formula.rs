//! `riemap formula`: the files are run by Python and Node, and compared with exact maps inside and on the boundary.

#![cfg(feature = "app")]
#![allow(clippy::panic, clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::conformal::{
    ConformalMap, Constraints, KernelMode, MapSettings, PerSide, PrepareSettings, Side, prepare, prepare_curve,
};
use riemap::exact::{Complex, blob, complex, disk, point, square, vshape};
use riemap::export::{FormulaFile, FormulaFormat};
use riemap::geometry::{CurvePoint, DVec2};
use riemap::outline::Preset;
use riemap::rational::{Formula, FormulaError};
use riemap::session::{Command as Edit, OutlineSpec, Session, SurfaceShape, SurfaceSpec};
use riemap::surface::SurfacePreset;
use riemap::worker::{Finding, FormulaTask, Study};
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;
use support::program::{fails, folder, names, succeeds};

const PYTHON: &str = "
import importlib.util, sys
spec = importlib.util.spec_from_file_location('formula', sys.argv[1])
formula = importlib.util.module_from_spec(spec)
spec.loader.exec_module(formula)
for line in sys.stdin:
    x, y = map(float, line.split())
    image = getattr(formula, sys.argv[2])(complex(x, y))
    print(repr(image.real), repr(image.imag))
";
const NODE: &str = "
const [file, name] = process.argv.slice(1);
const formula = require(file);
const lines = require('fs').readFileSync(0, 'utf8').trim().split('\\n');
for (const line of lines) console.log(...formula[name](line.split(' ').map(Number)));
";

/// The images of points under a function of a code file.
fn images(file: &Path, function: &str, points: &[Complex]) -> Vec<Complex> {
    let (program, flag, code) = match file.extension().unwrap().to_str().unwrap() {
        "py" => ("python3", "-c", PYTHON),
        _ => ("node", "-e", NODE),
    };
    let mut command = Command::new(program);
    command.args([flag, code]).arg(file).arg(function).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child =
        command.spawn().unwrap_or_else(|error| panic!("{program} is needed (`cargo xtask test` installs it): {error}"));
    let lines: Vec<String> = points.iter().map(|z| format!("{:?} {:?}\n", z.re, z.im)).collect();
    child.stdin.take().unwrap().write_all(lines.concat().as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{program}: {}", file.display());
    let number = |text: &str| text.parse::<f64>().unwrap();
    let point = |line: &str| line.split_once(' ').map(|(x, y)| Complex::new(number(x), number(y))).unwrap();
    let found: Vec<Complex> = String::from_utf8(output.stdout).unwrap().lines().map(point).collect();
    assert_eq!(found.len(), points.len());
    found
}

struct Written {
    folder: std::path::PathBuf,
    json: serde_json::Value,
}

/// Runs the command with these arguments, and reads what it writes.
fn written(name: &str, arguments: &[&str]) -> Written {
    let folder = folder(name);
    let files = ["json", "py", "js"].map(|extension| folder.join(format!("f.{extension}")));
    let mut all = vec!["formula"];
    all.extend(arguments);
    let paths: Vec<&str> = files.iter().map(|file| file.to_str().unwrap()).collect();
    all.extend(paths.iter().flat_map(|path| ["--out", path]));
    succeeds(&all);
    let json = serde_json::from_slice(&std::fs::read(&files[0]).unwrap()).unwrap();
    Written { folder, json }
}

impl Written {
    fn number(&self, function: &str, name: &str) -> f64 {
        self.json[function][name].as_f64().unwrap()
    }

    /// Checks both code files at these points against their exact images, to the stated error.
    fn check(&self, function: &str, points: &[Complex], exact: &[Complex]) {
        let part = if function == "f" { "f" } else { "inverse" };
        // the pairs themselves are right to about 1e-13
        let stated = self.number(part, "error") + 2e-13;
        for file in ["f.py", "f.js"] {
            let found = images(&self.folder.join(file), function, points);
            let off = found.iter().zip(exact).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
            let degree = self.number(part, "degree");
            println!("{file}, {function}: degree {degree}, off by {off:.1e}, stated {stated:.1e}");
            assert!(off <= stated, "{file}, {function}: off by {off:e}, stated {stated:e}");
        }
    }
}

/// Points of the unit disk up to this radius.
fn in_disk(radius: f64) -> Vec<Complex> {
    (1..=300).map(|k| Complex::from_polar(radius * (f64::from(k) / 300.0).sqrt(), 2.4 * f64::from(k))).collect()
}

#[test]
fn a_moebius_map_of_the_disk_has_degree_one() {
    let formula =
        written("disk", &["preset:disk", "preset:disk", "--source-point", "0.3,0.2", "--target-point", "0,0"]);
    assert_eq!((formula.number("f", "degree"), formula.number("inverse", "degree")), (1.0, 1.0));
    let points = in_disk(1.0);
    let exact: Vec<Complex> = points.iter().map(|&z| disk::moebius(Complex::new(0.3, 0.2), Complex::ONE, z)).collect();
    formula.check("f", &points, &exact);
    formula.check("f_inverse", &exact, &points);
    let pole = &formula.json["f"]["poles"][0];
    let pole = Complex::new(pole[0].as_f64().unwrap(), pole[1].as_f64().unwrap());
    assert!((pole - Complex::new(0.3, -0.2).inv()).norm() < 1e-11, "{pole}");
}

#[test]
fn the_blob_is_mapped_to_the_disk_with_eight_digits() {
    let center = "2.677813229026218,2.4668517113662407";
    let formula = written("blob", &["preset:blob", "preset:disk", "--source-point", center, "--target-point", "0,0"]);
    assert!(formula.json["digits_reached"].as_u64().unwrap() >= 8, "{}", formula.json["digits_reached"]);
    let exact = in_disk(0.999);
    let points: Vec<Complex> = exact.iter().map(|&z| blob::from_disk(z)).collect();
    formula.check("f", &points, &exact);
    formula.check("f_inverse", &exact, &points);
}

#[test]
fn the_square_is_mapped_to_the_disk_and_back() {
    let formula =
        written("square", &["preset:square", "preset:disk", "--source-point", "0,0", "--target-point", "0,0"]);
    assert!(formula.number("f", "digits_reached") >= 8.0);
    assert!(formula.number("inverse", "digits_reached") >= 6.0, "a right angle has 1e-16^(1/2) at its corner");
    // half the side is 0.9, and the first point is the middle of the upper side, which goes to 1
    let grid = |k: u32| Complex::new(f64::from(k % 20) - 9.5, f64::from(k / 20) - 9.5) * (0.9 * 0.99 / 9.5);
    let points: Vec<Complex> = (0..400).map(grid).collect();
    let exact: Vec<Complex> = points.iter().map(|&z| -Complex::I * square::to_disk(z / 0.9)).collect();
    formula.check("f", &points, &exact);
    formula.check("f_inverse", &exact, &points);
}

/// The map between two presets with their default points.
fn map(source: Preset, target: Preset, points: [Option<DVec2>; 2]) -> ConformalMap {
    let sides = [(source, points[0]), (target, points[1])].map(|(preset, point)| {
        let (outline, curve) = (preset.outline(), preset.curve().unwrap());
        let near: Vec<DVec2> = point.into_iter().collect();
        let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
        Arc::new(prepare_curve((outline.polygon(), &curve), &near, &settings, &mut |_| ()).unwrap())
    });
    let at = |k: usize| points[k].map_or_else(|| sides[k].default_point(), Into::into);
    let constraints = Constraints::new((at(0), 0.0), (at(1), 0.0));
    ConformalMap::new(sides[0].clone(), sides[1].clone(), &constraints, MapSettings::default()).unwrap()
}

/// Points all along a curve that no fit has chosen, with their images.
fn boundary_pairs(map: &ConformalMap, from: Side) -> [Vec<Complex>; 2] {
    let curves = map.curve_map(from).unwrap();
    let pieces = curves.from_curve().pieces().len();
    let point = |k: usize| CurvePoint::new(k % pieces, ((k as f64) * 0.618_033_988_749_894_9).fract());
    let points: Vec<CurvePoint> = (0..pieces * 200).map(point).collect();
    [
        points.iter().map(|&p| complex(curves.from_curve().position(p))).collect(),
        points.iter().map(|&p| complex(curves.onto_curve().position(curves.image(p)))).collect(),
    ]
}

#[test]
fn corners_of_the_l_shape_are_resolved() {
    let formula = written("l", &["preset:l-shape", "preset:disk"]);
    assert!(formula.number("f", "digits_reached") >= 8.0);
    let map = map(Preset::LShape, Preset::Disk, [None, None]);
    let [points, exact] = boundary_pairs(&map, Side::Source);
    formula.check("f", &points, &exact);
    let [points, exact] = boundary_pairs(&map, Side::Target);
    formula.check("f_inverse", &points, &exact);
}

#[test]
fn the_tip_of_the_v_shape_is_mapped_onto_the_blob() {
    let (x, center) = (DVec2::new(0.96, 0.8432), DVec2::new(2.677_813_229_026_218, 2.466_851_711_366_240_7));
    let target = "2.677813229026218,2.4668517113662407";
    let arguments =
        ["preset:v-shape", "preset:blob", "--digits", "6", "--source-point", "0.96,0.8432", "--target-point", target];
    let formula = written("v", &arguments);
    println!("{}", formula.json["digits_reached"]);
    let points: Vec<DVec2> = (0..2000).map(|k| vshape::boundary(f64::from(k) * 0.618)).collect();
    let exact: Vec<Complex> = points.iter().map(|&y| complex(blob::boundary(vshape::harmonic_measure(x, y)))).collect();
    let points: Vec<Complex> = points.into_iter().map(complex).collect();
    formula.check("f", &points, &exact);
    // seen from the tip, the other arm of the V is below what doubles tell apart on the blob: there is no inverse
    assert!(formula.json["inverse"].is_null() && formula.json["digits_reached"] == 0);
    assert!(formula.json["there_and_back"]["source"].is_null());
    for file in ["f.py", "f.js"] {
        let text = std::fs::read_to_string(formula.folder.join(file)).unwrap();
        assert!(text.contains("f_inverse is left out") && !text.contains("function f_inverse") && !text.contains('@'));
    }
    let formula = Formula::new(&map(Preset::VShape, Preset::Blob, [Some(x), Some(center)]), 6, &mut |_| true).unwrap();
    assert!(formula.forward.digits() >= 5 && formula.inverse.digits() == 0);
}

/// Narrow notches need many poles: at a degree of 200, and with poles inside taken out one after the other, the cinquefoil
/// had no digit, and the others five or six. Errors are measured on points that no fit has seen.
#[test]
fn outlines_with_many_notches_have_the_digits_that_were_asked_for() {
    let cases = [
        (Preset::Cinquefoil, [3, 8]),
        (Preset::Hand, [8, 8]),
        (Preset::Gingerbread, [8, 8]),
        // doubles resolve 1e-16^(1/5) at the tips
        (Preset::Star, [8, 2]),
    ];
    for (preset, digits) in cases {
        let map = map(preset, Preset::Disk, [None, None]);
        let formula = Formula::new(&map, 8, &mut |_| true).unwrap();
        let fits = [(Side::Source, &formula.forward, digits[0]), (Side::Target, &formula.inverse, digits[1])];
        for (side, fit, least) in fits {
            let [points, exact] = boundary_pairs(&map, side);
            let off = points.iter().zip(exact).map(|(&z, w)| (fit.function().at(z) - w).norm()).fold(0.0, f64::max);
            let (degree, found) = (fit.function().degree(), fit.digits());
            println!("{preset}, {side}: degree {degree}, {found} digits, off by {off:.1e}, stated {:.1e}", fit.error());
            assert!(found >= least, "{preset}, {side}: {found} digits");
            assert!(off <= 1.5 * fit.error(), "{preset}, {side}: off by {off:e}, stated {:e}", fit.error());
            let curve = map.curve_map(side).unwrap().from_curve();
            assert!(fit.poles().iter().all(|pole| !curve.contains(point(*pole))), "{preset}, {side}: a pole inside");
            assert!(fit.jump() == 0.0, "{preset}, {side}: {:e}", fit.jump());
        }
    }
}

/// From the disk, the inner end of the spiral is smaller than what doubles tell apart: that is said.
#[test]
fn where_doubles_cannot_name_the_points_it_says_so() {
    let formula = Formula::new(&map(Preset::Spiral, Preset::Disk, [None, None]), 8, &mut |_| true).unwrap();
    let (jump, error) = (formula.inverse.jump(), formula.inverse.error());
    println!("jump {jump:.1e}, error {error:.1e}");
    assert!(formula.forward.digits() >= 8 && formula.forward.jump() == 0.0);
    assert!(formula.inverse.digits() == 0 && jump > 0.5 && error >= 0.5 * jump, "{jump:e}, {error:e}");
    let output = succeeds(&["formula", "preset:disk", "preset:spiral", "--digits", "3"]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(stderr.contains("apart are one point in double precision"), "{stderr}");
}

#[test]
fn single_precision_has_its_stated_error_in_f32() {
    let folder = folder("glsl");
    let path = folder.join("f.glsl").display().to_string();
    succeeds(&["formula", "preset:blob", "preset:disk", "--digits", "4", "--out", &path]);
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("vec2 f(vec2 z)") && text.contains("vec2 f_inverse(vec2 w)") && !text.contains('@'));
    let count = |open: char| text.chars().filter(|&c| c == open).count();
    assert_eq!((count('('), count('{')), (count(')'), count('}')));
    let map = map(Preset::Blob, Preset::Disk, [None, None]);
    let formula = Formula::single(&map, 4, &mut |_| true).unwrap();
    let [points, exact] = boundary_pairs(&map, Side::Source);
    let off = points.iter().zip(exact).map(|(&z, w)| (formula.forward.function().at_single(z) - w).norm());
    let off = off.fold(0.0, f64::max);
    println!("in f32: off by {off:.1e}, stated {:.1e}", formula.forward.error());
    // z of the comparison is rounded too, by 3e-7 of the blob's size, where f has a slope of up to 14
    assert!(off <= formula.forward.error() + 1e-5, "{off:e}");
    // the numbers of the file are those of the function
    let listed = formula.forward.function().support()[0];
    assert!(text.contains(&format!("vec2({:?}, {:?})", listed.re as f32, listed.im as f32)));
}

#[test]
fn files_are_structured_as_their_languages_want() {
    let folder = folder("files");
    let path = |extension: &str| folder.join(format!("f.{extension}")).display().to_string();
    let (julia, json) = (path("jl"), path("json"));
    let output = succeeds(&["formula", "preset:disk", "preset:blob", "--digits", "3", "--out", &julia, "--out", &json]);
    assert!(String::from_utf8(output.stdout).unwrap().contains("f_inverse: degree"));
    let text = std::fs::read_to_string(&julia).unwrap();
    assert!(text.contains("f(z::Number)") && text.contains("f_inverse(w::Number)") && !text.contains('@'));
    assert!(text.lines().next().unwrap().starts_with("# A conformal map"));
    let json: serde_json::Value = serde_json::from_slice(&std::fs::read(&json).unwrap()).unwrap();
    for function in ["f", "inverse"] {
        let part = &json[function];
        let count = part["degree"].as_u64().unwrap() as usize + 1;
        for list in ["support_points", "values", "weights"] {
            assert_eq!(part[list].as_array().unwrap().len(), count, "{function}, {list}");
        }
        assert!(part["poles"].as_array().unwrap().len() < count);
        assert!(part["error"].as_f64().unwrap() <= 1e-3 * part["extent"].as_f64().unwrap());
        assert!(part["digits_reached"].as_u64().unwrap() >= 3);
    }
    assert!(json["there_and_back"]["source"].as_f64().unwrap() < 0.1);
}

#[test]
fn a_name_is_not_read_as_the_encoding_of_a_file() {
    let map = map(Preset::Disk, Preset::Disk, [Some(DVec2::new(0.3, 0.2)), None]);
    let formula = Formula::new(&map, 4, &mut |_| true).unwrap();
    let folder = folder("encoding");
    // Python decodes the second one to a line of its own, and runs it
    for name in ["decoding: test.svg", "coding:utf-7 +AAo-raise SystemExit(3)+AAo-#"] {
        let text = FormulaFile::new(PerSide::new(name, name), 4, &formula).text(FormulaFormat::Python);
        let path = support::program::file(&folder, "f.py", &text);
        let found = images(Path::new(&path), "f", &[Complex::new(0.3, 0.2)]);
        assert!(found[0].norm() < 1e-4, "{}", found[0]);
        assert!(text.contains(name) && !text.lines().take(2).any(|line| line.contains(name)), "{text}");
    }
}

#[test]
fn what_has_no_formula_is_refused_and_nothing_is_written() {
    let folder = folder("refused");
    let path = folder.join("f.json").display().to_string();
    fails(&["formula", "preset:disk", "preset:hemisphere", "--out", &path], 2, &["hemisphere", "surface"]);
    fails(&["formula", "preset:disk", "preset:disk", "--out", "f.txt"], 2, &["json, py, jl, js or glsl"]);
    fails(&["formula", "preset:disk", "preset:disk", "--digits", "14"], 2, &["--digits"]);
    fails(&["formula", "preset:disk", "preset:disk", "--source-point", "3,0", "--out", &path], 1, &["source"]);
    // a gear of 4,200 corners needs more unknowns than a map has
    let corner = |k: u32| {
        let [y, x] = <[f64; 2]>::from((std::f64::consts::TAU * f64::from(k) / 4200.0).sin_cos());
        let radius = if k.is_multiple_of(2) { 1.0 } else { 0.8 };
        format!("[{},{}]", radius * x, radius * y)
    };
    let gear = (0..4200).map(corner).collect::<Vec<_>>().join(",");
    let file = support::program::file(&folder, "gear.json", &format!("[{gear}]"));
    let output = support::program::riemap(&["formula", &file, "preset:disk", "--out", &path]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(1) && stderr.contains("the source has no exact boundary values"), "{stderr}");
    assert_eq!(names(&folder), ["gear.json"]);
}

#[test]
fn a_formula_of_finite_elements_is_refused() {
    let side = Arc::new(prepare(Preset::Disk.outline().polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap());
    let constraints = Constraints::new((side.default_point(), 0.0), (side.default_point(), 0.0));
    let map = ConformalMap::new(side.clone(), side, &constraints, MapSettings::default()).unwrap();
    let refused = Formula::new(&map, 8, &mut |_| true);
    assert_eq!(refused, Err(FormulaError::NoIntegral { side: Side::Source }));
}

#[test]
fn a_formula_is_cancelled_at_its_next_step() {
    let map = map(Preset::Square, Preset::Disk, [None, None]);
    let mut steps = 0;
    let result = Formula::new(&map, 8, &mut |done| {
        assert!((0.0..=1.0).contains(&done));
        steps += 1;
        steps < 20
    });
    assert!(matches!(result, Err(FormulaError::Cancelled(_))) && steps == 20, "{steps}");
}

/// All pairs of presets; takes a minute.
#[test]
#[ignore = "a table for the eye"]
fn degrees_and_digits_of_all_pairs() {
    for source in Preset::ALL {
        for target in Preset::ALL {
            let map = map(source, target, [None, None]);
            let started = std::time::Instant::now();
            match Formula::new(&map, 8, &mut |_| true) {
                Ok(formula) => println!(
                    "{source} → {target}: degree {}/{}, digits {}/{}, {:.1} s",
                    formula.forward.function().degree(),
                    formula.inverse.function().degree(),
                    formula.forward.digits(),
                    formula.inverse.digits(),
                    started.elapsed().as_secs_f64()
                ),
                Err(error) => println!("{source} → {target}: {error}, {:.1} s", started.elapsed().as_secs_f64()),
            }
        }
    }
}

/// The session of a map between two presets, with these interior points.
fn session(presets: [Preset; 2], points: [DVec2; 2]) -> Session {
    let outline = |side: Side| OutlineSpec::Preset(presets[side as usize]);
    let edits = Side::BOTH.map(|side| Edit::SetOutline { side, outline: outline(side) });
    let moves = Side::BOTH.map(|side| Edit::MoveInterior { side, point: points[side as usize].into() });
    Session::with(edits).and(moves).and([Edit::MoveAnchor { side: Side::Target, fraction: 0.1 }])
}

#[test]
fn the_app_writes_the_files_of_the_command_line() {
    let folder = folder("app");
    let session = session([Preset::Blob, Preset::Disk], [DVec2::new(2.5, 2.4), DVec2::new(0.1, 0.0)]);
    for format in FormulaFormat::ALL {
        let path = folder.join(format!("f.{}", format.extension()));
        let points = "--source-point 2.5,2.4 --target-point 0.1,0 --target-anchor @0.1 --digits 4";
        let points: Vec<&str> = points.split(' ').collect();
        succeeds(
            &[&["formula", "preset:blob", "preset:disk", "--out", path.to_str().unwrap()], points.as_slice()].concat(),
        );
        let mut last = 0.0;
        let task = FormulaTask::new(&session, format, 4).unwrap();
        let found = task.run(&mut |done| {
            assert!((0.0..=1.0).contains(&done));
            last = done;
            true
        });
        let found = found.unwrap().unwrap();
        assert!(found.text.as_bytes() == std::fs::read(&path).unwrap(), "{format:?}: another file");
        assert!(
            last > 0.5 && found.reached.source.digits >= 4 && found.reached.target.digits >= 4,
            "{last}, {found:?}"
        );
    }
}

#[test]
fn the_apps_formula_is_cancelled_and_refused_in_words() {
    let task = |session: &Session| FormulaTask::new(session, FormulaFormat::Json, 8).unwrap();
    let square = session([Preset::Square, Preset::Disk], [DVec2::new(0.1, 0.0), DVec2::ZERO]);
    for steps in [1, 3, 10] {
        let mut calls = 0;
        let study = Study::Formula(Box::new(task(&square)));
        let found = study.run(&mut |_| {
            calls += 1;
            calls < steps
        });
        assert!(found.is_none() && calls == steps, "{calls} calls: {found:?}");
    }
    let outside = session([Preset::Square, Preset::Disk], [DVec2::new(3.0, 0.0), DVec2::ZERO]);
    let Some(Finding::Failed(reason)) = Study::Formula(Box::new(task(&outside))).run(&mut |_| true) else { panic!() };
    assert!(reason.english().contains("source"), "{reason:?}");
    let shape = SurfaceShape::preset(SurfacePreset::Hemisphere);
    let surface = Session::with([Edit::SetSurface { side: Side::Target, surface: SurfaceSpec::new(shape) }]);
    let Some(Finding::Failed(reason)) = Study::Formula(Box::new(task(&surface))).run(&mut |_| true) else { panic!() };
    assert_eq!(reason.english(), "the target is a surface; a formula is for two outlines");
}
