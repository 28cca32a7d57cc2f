//! What results of strokes, offsets, unions and simplifications are made of: curves where the input has curves, and few
//! segments.

use crate::support::paths::path;
use crate::support::{Rng, cases, real};
use casteljau::path::{
    BooleanOperation, FillRule, OffsetOptions, StrokeCap, StrokeOptions, take_replaced_segments,
};
use casteljau::spline::Join;
use casteljau::{Error, Path};

const JOINS: [Join; 3] = [Join::Round, Join::Bevel, Join::Miter];
const CAPS: [StrokeCap; 3] = [StrokeCap::Round, StrokeCap::Butt, StrokeCap::Square];

/// A path of one to three quadratics and cubics whose coordinates are from 0 to 10 with one decimal.
fn random_path(rng: &mut Rng, closed: bool) -> Path {
    let points = |count: usize, rng: &mut Rng| {
        let mut one = || real(rng.below(101)) / 10.0;
        let pairs = (0..count).map(|_| format!("{},{}", one(), one()));
        pairs.collect::<Vec<String>>().join(" ")
    };
    let mut d = format!("M{}", points(1, rng));
    for _ in 0..1 + rng.below(3) {
        let (letter, count) = rng.pick(&[('Q', 2), ('C', 3)]);
        d += &format!("{letter}{}", points(count, rng));
    }
    path(&(d + if closed { "Z" } else { "" }))
}

fn distance(rng: &mut Rng) -> f64 {
    real(1 + rng.below(400)) / 100.0
}

fn is_of_lines(path: &Path) -> bool {
    path.segments().all(|curve| curve.degree() == 1)
}

/// Checks the results of a function of random paths: no error, and curves where the input has curves, except for one
/// result in 10⁵. The mean number of segments exceeds the given one by less than 5 %.
fn check(mean: f64, mut call: impl FnMut(&mut Rng) -> (Path, Result<Path, Error>)) {
    let count = cases(4_000, 1_000_000);
    let (mut segments, mut lost) = (0, Vec::new());
    for seed in 0..count {
        let (input, result) = call(&mut Rng(seed as u64));
        let result = result.unwrap_or_else(|error| panic!("{seed}: {error}\n{input}"));
        if result.segment_count() > 60 && is_of_lines(&result) && !is_of_lines(&input) {
            lost.push(format!("{seed}: {} lines\n{input}", result.segment_count()));
        }
        segments += result.segment_count();
    }
    assert!(
        lost.len() <= count / 100_000,
        "{}: {}",
        lost.len(),
        lost.join("\n")
    );
    let found = real(segments) / real(count);
    println!("{found} segments, {mean} when this was written");
    assert!(found < 1.05 * mean, "{found} segments instead of {mean}");
}

#[test]
fn strokes_are_made_of_curves() {
    check(17.0, |rng| {
        let closed = rng.chance(0.25);
        let path = random_path(rng, closed);
        let options = StrokeOptions::new()
            .join(rng.pick(&JOINS))
            .cap(rng.pick(&CAPS));
        let stroke = path.stroke(distance(rng), &options);
        (path, stroke)
    });
}

#[test]
fn offsets_are_made_of_curves() {
    check(8.0, |rng| {
        let path = random_path(rng, true);
        let options = OffsetOptions::new().join(rng.pick(&JOINS));
        let offset = path.offset(rng.sign() * distance(rng), &options);
        (path, offset)
    });
}

#[test]
fn unions_are_made_of_curves() {
    check(13.939, |rng| {
        let [a, b] = [(); 2].map(|()| random_path(rng, true));
        let union = Path::combine([&a, &b], BooleanOperation::Union, FillRule::NonZero);
        (a, union)
    });
}

#[test]
fn simplifications_are_made_of_curves() {
    check(2.487, |rng| {
        let closed = rng.chance(0.5);
        let path = random_path(rng, closed);
        let simplified = path.simplify(rng.magnitude(-3.0, -0.5));
        (path, simplified)
    });
}

/// The strokes of 3.06 and 3.9 became 1,188 lines and an error.
#[test]
fn strokes_next_to_cusps_of_their_sides_have_few_segments() {
    for (d, width, most) in [
        ("M5.3 8.3Q2 1.9 3.8 3.3", 3.06, 16),
        ("M7.8,0.4 C8,1.8 2,6.2 1.6,8", 3.9, 16),
    ] {
        let stroke = path(d)
            .stroke(width, &StrokeOptions::new())
            .expect("a stroke");
        assert!(stroke.segment_count() <= most, "{}", stroke.segment_count());
    }
}

/// The straight cubic stands still at both ends, and coincides with a part of a straight quadratic.
const STANDING_STILL: &str =
    "M0,1 L-0.3,3.2 C0.6,0.7 0.2,0.4 0,0 Q0,2 0,2 C0.7,2.1 0.3,2.1 0,2 C0,2 0,1 0,1";

#[test]
fn straight_cubics_that_stand_still_coincide() {
    take_replaced_segments();
    let region = path(STANDING_STILL).remove_overlaps(FillRule::NonZero);
    assert_eq!(region.expect("a region").segment_count(), 8);
    assert_eq!(take_replaced_segments(), 0);
}

/// A cubic that turns back next to its start, at a distance of some ε from a line: the outlines contradict each other.
const CONTRADICTORY: &str = "M-0.001,1.001 L2.0001,0.0001 L-0.001,-0.002 L2.0001,0.0001 C2.0000002,0 1.9999998,1.0000001 0.01,-0.02 Z";

#[test]
fn lines_replace_only_the_segments_of_a_contradiction() {
    let contradictory = path(CONTRADICTORY);
    take_replaced_segments();
    let region = contradictory.remove_overlaps(FillRule::NonZero);
    assert!(region.is_ok());
    assert!(take_replaced_segments() > 0, "choose another example");
    // A curve that crosses it, one that touches nothing, and another contradiction.
    let crossing = path("M1 -1C1.3 0 0.7 1 1 2H1.1C0.8 1 1.4 0 1.1 -1Z");
    let apart = path("M5 0C6 1 7 0 8 1V2C7 3 6 2 5 3Z");
    let union = Path::combine(
        [&contradictory, &crossing, &apart],
        BooleanOperation::Union,
        FillRule::NonZero,
    );
    let union = union.expect("a union");
    assert!(
        union.subpaths().any(|one| Path::from(one) == apart),
        "{union}"
    );
    let curves = union.segments().filter(|curve| curve.degree() == 3);
    let of_crossing = curves.filter(|curve| curve.start().x < 2.0).count();
    assert!((2..=8).contains(&of_crossing), "{of_crossing} cubics");
    // Within the distance that the documentation gives.
    let areas = [&contradictory, &crossing, &apart].map(|one| {
        let region = one.remove_overlaps(FillRule::NonZero);
        region.expect("a region").area()
    });
    let all = union.area();
    assert!(
        all < areas.iter().sum::<f64>() && all > areas[0].max(areas[1]),
        "{all} {areas:?}"
    );
}
