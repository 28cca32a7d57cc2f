//! Path data: round trips, agreement of the Rust and JavaScript APIs, invalid data, large texts.

use crate::path::texts::{Rng, hash, text};
use crate::support::allocations::allocated_by;
use crate::support::{Rng as Numbers, ulp};
use casteljau::glam::DVec2;
use casteljau::{Path, Spline};

/// The number of cases; millions with CASTELJAU_DEEP=1.
fn cases(usual: usize) -> usize {
    let deep = std::env::var_os("CASTELJAU_DEEP").is_some_and(|value| value != "0");
    if deep { 50 * usual } else { usual }
}

fn read(d: &str) -> (Path, String) {
    match Path::from_svg(d) {
        Ok(path) => (path, String::new()),
        Err(error) => (error.path.clone(), error.to_string()),
    }
}

fn print(path: &Path) -> String {
    path.to_svg(None, None).expect("no tolerance")
}

/// The hash of the results for the 20,000 texts: their messages, the paths with all digits, the paths in short form.
/// The same number is in tests/js/path.test.js; it changes only if the reader or the writer changes.
const HASH_OF_ALL: u32 = 1_885_360_373;

#[test]
fn rust_and_javascript_read_and_write_the_same() {
    let mut rng = Rng::new(1);
    let (mut state, mut wrong) = (0x811c_9dc5, 0);
    for case in 0..20_000_u32 {
        let d = text(&mut rng);
        let (path, message) = read(&d);
        wrong += u32::from(!message.is_empty());
        let all = print(&path);
        let brief = path
            .to_svg(Some(u8::try_from(case % 8).expect("small")), None)
            .expect("no tolerance");
        for text in [&message, &all, &brief] {
            state = hash(state, text);
        }
        assert_eq!(read(&all).0, path, "{d:?}");
        let again = read(&brief);
        assert_eq!(again.1, "", "{brief:?} of {d:?}");
        assert_eq!(
            again.0.segment_count(),
            path.segment_count(),
            "{brief:?} of {d:?}"
        );
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
        4 => rng.pick(&[
            casteljau::MAX_COORDINATE,
            f64::MIN_POSITIVE,
            5e-324,
            -casteljau::MAX_COORDINATE,
        ]),
        5 => Some(f64::from_bits(rng.next()))
            .filter(|x| x.abs() <= casteljau::MAX_COORDINATE)
            .unwrap_or(1.0),
        _ => rng.signed(),
    }
}

fn adversarial_path(rng: &mut Numbers) -> Path {
    let splines: Vec<Spline<DVec2>> = (0..rng.below(4))
        .map(|_| {
            let closed = rng.chance(0.5);
            let degrees: Vec<usize> = (0..=rng.below(4)).map(|_| 1 + rng.below(3)).collect();
            let count = degrees.iter().sum::<usize>() + usize::from(!closed);
            let few: Vec<DVec2> = (0..4)
                .map(|_| DVec2::new(adversarial_number(rng), adversarial_number(rng)))
                .collect();
            let points = (0..count)
                .map(|_| {
                    if rng.chance(0.4) {
                        rng.pick(&few)
                    } else {
                        DVec2::new(adversarial_number(rng), adversarial_number(rng))
                    }
                })
                .collect();
            Spline::with_degrees(points, &degrees, closed).expect("matching counts")
        })
        .collect();
    Path::new(&splines)
}

fn bits(path: &Path) -> Vec<(bool, Vec<usize>, Vec<u64>)> {
    let numbers = |spline: &Spline<DVec2>| {
        let points = spline.control_points().iter();
        points
            .flat_map(|p| [p.x.to_bits(), p.y.to_bits()])
            .collect()
    };
    let splines = path.subpaths().collect::<Vec<_>>();
    let parts = splines.iter();
    parts
        .map(|spline| (spline.is_closed(), spline.degrees(), numbers(spline)))
        .collect()
}

#[test]
fn all_paths_come_back_to_the_bit() {
    let mut rng = Numbers(2);
    for _ in 0..cases(20_000) {
        let path = adversarial_path(&mut rng);
        let text = print(&path);
        let again = Path::from_svg(&text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(bits(&again), bits(&path), "{text}");
        // In short form: the same structure, and no coordinate is off by more than half a digit.
        let digits = u8::try_from(rng.below(20)).expect("small");
        let brief = path.to_svg(Some(digits), None).expect("no tolerance");
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
            let brief = path.to_svg(Some(digits), None).expect("no tolerance");
            let rounded = Path::from_svg(&brief)
                .expect("own text")
                .subpaths()
                .collect::<Vec<_>>();
            for (p, q) in rounded[0].control_points().iter().zip(&points) {
                let max = 0.5 * 10_f64.powi(-i32::from(digits)) + 2.0 * ulp(1e6);
                assert!((*p - *q).abs().max_element() <= max, "{brief}");
            }
        }
    }
}

#[test]
fn garbage_is_refused_and_what_came_before_is_kept() {
    let alphabet: Vec<char> = "MmLlHhVvCcSsQqTtAaZz0123456789.,-+eE \t\n\r\u{c}xé😀\0"
        .chars()
        .collect();
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
                assert!(
                    error.offset <= d.len() && d.is_char_boundary(error.offset),
                    "{d:?}"
                );
                // The path is that of the text before the error, as far as this text can be read.
                let before = read(&d[..error.offset]).0;
                assert!(
                    before.segment_count() >= error.path.segment_count(),
                    "{d:?}: {error}"
                );
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
    assert!(
        many > 500_000 && many / few == 10,
        "{few} and {many} segments"
    );
    // The lists grow by doubling, so their contents may fill little more than half of their capacity.
    assert!(much < 20 * little, "{little} and {much} bytes");
}

#[test]
fn no_repetition_takes_long_or_much_memory() {
    let good = [
        "z",
        "m0 0",
        "M0 0",
        "l0 0",
        "h0",
        "M0 0z",
        "0 0 ",
        "a0 0 0 0 0 0 0",
        "a1 1 0 00 1 1",
    ];
    for piece in good {
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
    assert!(
        Path::from_svg(&megabytes(" ", 3))
            .expect("blanks")
            .is_empty()
    );
}

#[test]
fn higher_degrees_are_written_as_cubics() {
    let points = [(0, 0), (1, 9), (8, -9), (4, 7), (3, -5), (9, 2)]
        .map(|(x, y)| DVec2::new(x.into(), y.into()));
    let curve = casteljau::Curve::new(&points).expect("six points");
    let text = curve.to_svg(None, Some(1e-3)).expect("a tolerance");
    let path = Path::from_svg(&text).expect("own text");
    assert!(path.segment_count() > 1);
    let spline = &path.subpaths().collect::<Vec<_>>()[0];
    assert!(spline.degrees().iter().all(|&degree| degree == 3));
    // Equal halving: each cubic belongs to an equal part of the parameter range.
    let line = curve.flatten(1e-4).expect("a tolerance");
    for p in spline.sample(8).expect("few") {
        let near = line.points.windows(2).any(|pair| {
            let (a, b, q) = (pair[0].extend(0.0), pair[1].extend(0.0), p.extend(0.0));
            crate::support::measure::from_segment(q, a, b) <= 1.1e-3 + 1e-4
        });
        assert!(near, "{p}");
    }
    assert!(curve.to_svg(None, Some(1e-30)).is_err());
    assert!(Path::default().to_svg(None, Some(-1.0)).is_err());
}
