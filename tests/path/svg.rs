//! Path data: round trips, agreement of the Rust and JavaScript APIs, invalid data, large texts.

use crate::path::texts::{Rng, hash, text};
use crate::support::allocations::allocated_by;
use crate::support::measure::from_polyline;
use crate::support::paths::{bits, path, points, polygons};
use crate::support::{Rng as Numbers, deep, ulp};
use casteljau::glam::{DAffine2, DMat2, DVec2};
use casteljau::path::{PathBuilder, SvgOptions};
use casteljau::{Curve, MAX_COORDINATE, Path, Spline};

/// The number of cases; millions with CASTELJAU_DEEP=1.
fn cases(usual: usize) -> usize {
    if deep() { 50 * usual } else { usual }
}

fn read(d: &str) -> (Path, String) {
    match Path::from_svg(d) {
        Ok(path) => (path, String::new()),
        Err(error) => (error.path.clone(), error.to_string()),
    }
}

fn print(path: &Path) -> String {
    path.to_svg()
}

/// A path in short form.
fn brief(path: &Path, digits: u8) -> String {
    path.to_svg_with(&SvgOptions::new().precision(digits))
        .expect("no tolerance")
}

/// The hash of the results for the 20,000 texts: their messages, the paths with all digits, the paths in short form.
/// The same number is in tests/js/path.test.js; it changes only if the reader or the writer changes.
const HASH_OF_ALL: u32 = 149_936_219;

/// The hash of the texts of 2,000 arcs of finer cubics; the same number is in tests/js/path.test.js.
const HASH_OF_ARCS: u32 = 1_608_952_176;

/// Whether the path that is read from a text is the one that was written: arcs are read up to rounding.
fn is_same(read: &Path, path: &Path, text: &str) -> bool {
    read == path || text.contains('A') && read.approx_eq(path, 1e-13 * largest(path))
}

fn largest(path: &Path) -> f64 {
    let bounds = path.control_bounds();
    bounds.map_or(0.0, |b| b.min.abs().max(b.max.abs()).max_element())
}

#[test]
fn rust_and_javascript_read_and_write_the_same() {
    let mut rng = Rng::new(1);
    let (mut state, mut wrong) = (0x811c_9dc5, 0);
    for case in 0..20_000_u32 {
        let d = text(&mut rng);
        let (path, message) = read(&d);
        wrong += u32::from(!message.is_empty());
        let all = print(&path);
        let brief = brief(&path, u8::try_from(case % 8).expect("small"));
        for text in [&message, &all, &brief] {
            state = hash(state, text);
        }
        assert!(is_same(&read(&all).0, &path, &all), "{d:?}");
        let (again, message) = read(&brief);
        assert_eq!(message, "", "{brief:?} of {d:?}");
        let counts = [&again, &path].map(Path::segment_count);
        assert_eq!(counts[0], counts[1], "{brief:?} of {d:?}");
    }
    assert!((1_000..4_000).contains(&wrong), "{wrong}");
    assert_eq!(state, HASH_OF_ALL);
}

/// Numbers of every size, with a preference for those with special cases.
fn adversarial_number(rng: &mut Numbers) -> f64 {
    match rng.below(8) {
        0 => 0.0,
        1 => -0.0,
        2 => rng.pick(&[1.0, -1.0, 0.5, 1e21, 1e-7, 123_456_789.125]),
        3 => f64::from_bits(rng.next() >> 12), // subnormal
        4 => rng.pick(&[MAX_COORDINATE, f64::MIN_POSITIVE, 5e-324, -MAX_COORDINATE]),
        5 => {
            let x = f64::from_bits(rng.next());
            if x.abs() <= MAX_COORDINATE { x } else { 1.0 }
        }
        _ => rng.signed(),
    }
}

fn adversarial_spline(rng: &mut Numbers) -> Spline<DVec2> {
    let closed = rng.chance(0.5);
    let degrees: Vec<usize> = (0..=rng.below(4)).map(|_| 1 + rng.below(3)).collect();
    let point = |rng: &mut Numbers| DVec2::new(adversarial_number(rng), adversarial_number(rng));
    let few = [(); 4].map(|()| point(rng));
    let any = |rng: &mut Numbers| match rng.chance(0.4) {
        true => rng.pick(&few),
        false => point(rng),
    };
    let count = degrees.iter().sum::<usize>() + usize::from(!closed);
    let points = (0..count).map(|_| any(rng)).collect();
    Spline::with_degrees(points, &degrees, closed).expect("matching counts")
}

#[test]
fn all_paths_come_back_to_the_bit() {
    let mut rng = Numbers(2);
    for _ in 0..cases(20_000) {
        let count = rng.below(4);
        let path: Path = (0..count).map(|_| adversarial_spline(&mut rng)).collect();
        let text = print(&path);
        let again = Path::from_svg(&text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let parts = |path: &Path| -> Vec<_> {
            let splines = path.subpaths();
            splines
                .map(|s| (s.is_closed(), s.degrees(), bits(s.control_points())))
                .collect()
        };
        if text.contains('A') {
            // Cubics that are an arc, also by chance, are read up to rounding.
            let most = 128.0 * f64::EPSILON * path.control_bounds().map_or(0.0, |b| b.diagonal());
            assert!(again.approx_eq(&path, most), "{text}");
        } else {
            assert_eq!(parts(&again), parts(&path), "{text}");
        }
        // In short form: the same structure, and no coordinate is off by more than half a digit.
        let digits = u8::try_from(rng.below(20)).expect("small");
        let brief = brief(&path, digits);
        let rounded = Path::from_svg(&brief).unwrap_or_else(|error| panic!("{brief}: {error}"));
        assert_eq!(rounded.subpath_count(), path.subpath_count(), "{brief}");
        assert!(brief.len() <= 2 + text.len().max(2) * 23, "{brief}");
    }
}

#[test]
fn rounding_moves_by_no_more_than_half_a_digit() {
    let mut rng = Numbers(3);
    for _ in 0..cases(5_000) {
        let mut number = || rng.signed() * 10_f64.powi(i32::try_from(rng.below(7)).expect("small"));
        let points: Vec<DVec2> = (0..7).map(|_| DVec2::new(number(), number())).collect();
        let path = Path::from(Spline::new(&points, 3, false).expect("seven points"));
        for digits in 0..12_u8 {
            let brief = brief(&path, digits);
            let rounded = crate::support::paths::path(&brief).subpath(0);
            for (p, q) in rounded
                .expect("a spline")
                .control_points()
                .iter()
                .zip(&points)
            {
                let max = 0.5 * 10_f64.powi(-i32::from(digits)) + 2.0 * ulp(1e6);
                assert!((*p - *q).abs().max_element() <= max, "{brief}");
            }
        }
    }
}

#[test]
fn garbage_is_refused_and_what_came_before_is_kept() {
    let alphabet = "MmLlHhVvCcSsQqTtAaZz0123456789.,-+eE \t\n\r\u{c}xé😀\0";
    let alphabet: Vec<char> = alphabet.chars().collect();
    let mut rng = Numbers(4);
    for _ in 0..cases(20_000) {
        let length = rng.below(60);
        let mut d: String = (0..length).map(|_| rng.pick(&alphabet)).collect();
        if rng.chance(0.7) {
            d.insert_str(0, "M1 2");
        }
        match Path::from_svg(&d) {
            Ok(path) => assert_eq!(read(&print(&path)).0, path),
            Err(error) => {
                assert!(d.is_char_boundary(error.offset), "{d:?}");
                // The path is that of the text before the error, as far as this text can be read.
                let before = read(&d[..error.offset]).0.segment_count();
                assert!(before >= error.path.segment_count(), "{d:?}: {error}");
            }
        }
    }
}

/// A text of several megabytes.
fn megabytes(piece: &str, megabytes: usize) -> String {
    piece.repeat(megabytes * 1_000_000 / piece.len())
}

/// Reading in quadratic time would take hours.
#[test]
fn ten_megabytes_need_ten_times_the_memory_of_one() {
    let icon = "m12.5 3.25c-1.5.5-3 1.25-4 2.75s-1 3.5.25 5 4 1.5 5.5 0h2l3-1.5q1-2 0-3.5t-2-1zm2 1a2 3 15 012.5 1.5z";
    let read = |size: usize| {
        let outline = "M0 0".to_owned() + &megabytes(icon, size);
        let (path, bytes) = allocated_by(|| Path::from_svg(&outline).expect("good data"));
        assert!(path.bounds().is_some());
        (path.segment_count(), bytes)
    };
    let ((few, little), (many, much)) = (read(1), read(10));
    assert!(many > 500_000 && many / few == 10, "{few} and {many}");
    // The lists grow by doubling, so their contents may fill little more than half of their capacity.
    assert!(much < 20 * little, "{little} and {much} bytes");
}

#[test]
fn no_repetition_takes_long_or_much_memory() {
    let good = ["z", "m0 0", "M0 0", "l0 0", "h0", "M0 0z", "0 0 "];
    let arcs = ["a0 0 0 0 0 0 0", "a1 1 0 00 1 1"];
    for piece in good.into_iter().chain(arcs) {
        let d = "M0 0 ".to_owned() + &megabytes(piece, 3);
        let path = Path::from_svg(&d).expect("good data");
        // Coordinates, degrees and ends of subpaths take at most 32 bytes for each character (arcs take more).
        assert!(path.segment_count() <= d.len(), "{piece}");
    }
    let bad = [
        "9", "e", "-", ".", ",", " ,", "M", "\u{a0}", "1.", "--", "1e9", "((", "\0",
    ];
    for piece in bad {
        let d = "M0 0L".to_owned() + &megabytes(piece, 3);
        let error = Path::from_svg(&d).expect_err(piece);
        assert!(error.to_string().len() < 400, "{piece}");
    }
    assert_eq!(Path::from_svg(&megabytes(" ", 3)), Ok(Path::default()));
}

#[test]
fn higher_degrees_are_written_as_cubics() {
    let curve = Curve::new(&points("0 0  1 9  8 -9  4 7  3 -5  9 2")).expect("six points");
    let text = curve
        .to_svg_with(&SvgOptions::new().tolerance(1e-3))
        .expect("a tolerance");
    let written = path(&text);
    assert!(written.segment_count() > 1);
    let spline = written.subpath(0).expect("a spline");
    assert!(spline.degrees().iter().all(|&degree| degree == 3));
    let polygon = polygons(&Path::from(curve.clone()), 1e-4).concat();
    for p in spline.sample(8).expect("few") {
        assert!(from_polyline(p, &polygon) <= 1.1e-3 + 1e-4, "{p}");
    }
    assert!(
        curve
            .to_svg_with(&SvgOptions::new().tolerance(1e-30))
            .is_err()
    );
    assert!(
        Path::default()
            .to_svg_with(&SvgOptions::new().tolerance(-1.0))
            .is_err()
    );
}

#[test]
fn errors_of_parsers_become_errors() {
    fn read() -> Result<(), casteljau::Error> {
        let _ = Path::from_svg("M0 0L1 1,2")?;
        Ok(())
    }
    let message = read().map_err(|error| error.to_string());
    let expected = "d: expected a number at offset 10";
    assert_eq!(message, Err(expected.to_owned()));
    let easing = casteljau::Error::from("steps(4, ende)".parse::<casteljau::Easing>().unwrap_err());
    assert_eq!(
        easing.to_string(),
        "easing: expected jump-start, jump-end, jump-none, jump-both, start or end at offset 9"
    );
    let surface = casteljau::Error::from(
        casteljau::Surface::parse("1\n1 1\n0 0 0\n1 0\n0 1 0\n1 1 0\n").unwrap_err(),
    );
    assert_eq!(surface.to_string(), "text: expected another text in line 4");
}

fn commands(text: &str) -> String {
    text.chars().filter(char::is_ascii_alphabetic).collect()
}

#[test]
fn shapes_are_written_as_arcs() {
    let center = DVec2::new(3.0, -4.0);
    let circle = Path::circle(center, 5.0).expect("a circle");
    assert_eq!(circle.to_svg(), "M8,-4 A5,5 0 0 1 -2,-4 A5,5 0 0 1 8,-4 Z");
    assert_eq!(brief(&circle, 1), "M8-4A5 5 0 0 1-2-4 5 5 0 0 1 8-4Z");
    let plain = circle.to_svg_with(&SvgOptions::new().arcs(false));
    assert_eq!(read(&plain.expect("no tolerance")).0, circle);
    let rounded = Path::rounded_rect(center, DVec2::new(8.0, 6.0), [1.5; 4]).expect("a rectangle");
    assert_eq!(commands(&rounded.to_svg()), "MLALALALAZ");
    let ellipse = Path::ellipse(center, DVec2::new(5.0, 2.0), 0.3).expect("an ellipse");
    assert_eq!(commands(&ellipse.to_svg()), "MAAZ");
    // Four cubics are no arc that is read so.
    let four =
        Path::from_svg("M1 0C1 .5523 .5523 1 0 1S-1 .5523 -1 0S-.5523 -1 0 -1S1 -.5523 1 0Z");
    assert_eq!(commands(&four.expect("path data").to_svg()), "MCCCCZ");
    let image = circle.transform(&DAffine2::from_mat2(DMat2::from_cols_array(&[
        1.0, 0.2, 0.7, 2.0,
    ])));
    assert_eq!(commands(&image.expect("finite").to_svg()), "MAAZ");
}

#[test]
fn equal_arcs_of_one_ellipse_are_written_as_one() {
    let square = Path::rect(DVec2::ZERO, DVec2::splat(10.0)).expect("a square");
    let rounded = square.round_corners(2.0).expect("a radius");
    assert!(rounded.segment_count() > 20, "fine cubics");
    let text = "M2 0H8A2 2 0 0 1 10 2V8A2 2 0 0 1 8 10H2A2 2 0 0 1 0 8V2A2 2 0 0 1 2 0Z";
    assert_eq!(brief(&rounded, 3), text);
    assert_eq!(commands(&print(&rounded)), "MLALALALAZ");
    // Both corners at an end of a stadium are one half circle.
    let pill = square.round_corners(5.0).expect("a radius");
    assert_eq!(commands(&print(&pill)).matches('A').count(), 2);
    let mut builder = PathBuilder::new();
    builder
        .arc_tolerance(1e-9)
        .circle(DVec2::new(3.0, -4.0), 5.0);
    let circle = builder.build().expect("a circle");
    assert_eq!(print(&circle), "M8,-4 A5,5 0 0 1 -2,-4 A5,5 0 0 1 8,-4 Z");
    let thirds = read("M5 0A5 5 0 0 1 4 3A5 5 0 0 1 1.4 4.8A5 5 0 0 1-1.76 4.68").0;
    assert_eq!(print(&thirds), "M5,0 A5,5 0 0 1 -1.76,4.68");
}

#[test]
fn arcs_of_finer_cubics_are_read_again_with_the_same_tolerance() {
    let mut rng = Rng::new(5);
    let (mut state, mut missed) = (0x811c_9dc5, 0);
    for case in 0..2_000 {
        let mut below = |count: u32| rng.below(count);
        let numbers = [40, 40, 180, 2, 2, 80].map(&mut below);
        let [rx, ry, degrees, large, sweep, x] = numbers;
        let d = format!(
            "M1 2A{} {} {degrees} {large} {sweep} {} 7",
            rx + 9,
            ry + 9,
            x + 2
        );
        let digits = i32::try_from(5 + below(5)).expect("few");
        let tolerance = 10_f64.powi(-digits);
        let path = Path::from_svg_with(&d, tolerance).expect("path data");
        let text = print(&path);
        let back = Path::from_svg_with(&text, tolerance).expect("own text");
        assert!(is_same(&back, &path, &text), "{case}: {d} {text}");
        missed += usize::from(commands(&text) != "MA");
        for text in [&text, &brief(&path, u8::try_from(case % 8).expect("few"))] {
            state = hash(state, text);
        }
    }
    assert_eq!(missed, 0);
    assert_eq!(state, HASH_OF_ARCS); // as in tests/js/path.test.js
}

/// Random arcs are written as one arc or two, and read again up to rounding or to the last digit.
#[test]
fn arcs_come_back_as_arcs() {
    let mut rng = Numbers(43);
    let mut missed = 0;
    for case in 0..cases(4000) {
        let to = rng.point(2) * 10.0;
        let radii = [0, 1].map(|_| rng.magnitude(-1.0, 2.0));
        let (degrees, large, sweep) = (rng.signed() * 180.0, rng.below(2), rng.below(2));
        let d = format!(
            "M1 2A{} {} {degrees} {large} {sweep} {} {}",
            radii[0], radii[1], to.x, to.y
        );
        let (path, message) = read(&d);
        assert_eq!(message, "");
        let text = print(&path);
        missed += usize::from(commands(&text) != "MA");
        assert!(is_same(&read(&text).0, &path, &text), "{case}: {d} {text}");
        let digits = 1 + rng.below(6);
        let short = brief(&path, u8::try_from(digits).expect("few"));
        let unit = 1.01 * 10_f64.powi(-i32::try_from(digits).expect("few"));
        assert!(
            read(&short).0.approx_eq(&path, 1.5 * unit),
            "{case}: {d} {short}"
        );
        // One control point is elsewhere: not the arc.
        let spline = path.subpaths().next().expect("an arc");
        let mut points = spline.control_points().to_vec();
        points[1] += DVec2::splat(1e-6);
        let other = Path::from(Spline::new(&points, 3, false).expect("cubics"));
        let back = read(&print(&other)).0;
        assert!(is_same(&back, &other, &print(&other)), "{case}");
    }
    // Of ellipses 100 times as long as wide, the digits of the cubics do not always determine the arc.
    assert!(missed < cases(4000) / 10, "{missed}");
}
