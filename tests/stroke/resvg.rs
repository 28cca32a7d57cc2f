//! The pictures of resvg's tests of strokes, from tests/data/strokes.

use casteljau::Path;
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, Join, StrokeCap, StrokeOptions};

/// Pixels along each side of a picture, and the side of its square.
const PIXELS: usize = 300;
const SIDE: f64 = 200.0;

struct Case<'a> {
    name: &'a str,
    stroke: Path,
    picture: &'a str,
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

fn read(line: &str) -> Case<'_> {
    let fields: Vec<&str> = line.split('\t').collect();
    let [name, d, width, cap, join, limit, dash, offset, picture] = fields[..] else {
        panic!("expected nine fields, got {}", fields.len());
    };
    let cap = match cap {
        "butt" => StrokeCap::Butt,
        "round" => StrokeCap::Round,
        _ => StrokeCap::Square,
    };
    let join = match join {
        "bevel" => Join::Bevel,
        "round" => Join::Round,
        _ => Join::Miter,
    };
    let dash: Vec<f64> = dash.split_whitespace().map(number).collect();
    let options = StrokeOptions::new()
        .cap(cap)
        .join(join)
        .miter_limit(number(limit))
        .dash(&dash, number(offset))
        .tolerance(1e-3);
    let path: Path = d.parse().expect("path data");
    let stroke = path.stroke(number(width), &options).expect("a stroke");
    Case {
        name,
        stroke,
        picture,
    }
}

/// The runs of a picture: the index of the first pixel, the number of pixels, and their kind.
fn runs(picture: &str) -> Vec<(usize, usize, char)> {
    let mut start = 0;
    picture
        .split_inclusive(['#', '.', '?'])
        .map(|run| {
            let (count, kind) = run.split_at(run.len() - 1);
            let count = count.parse().expect("a count of pixels");
            start += count;
            (start - count, count, kind.chars().next().expect("a kind"))
        })
        .collect()
}

fn centre(pixel: usize) -> DVec2 {
    let at = |k: usize| (k as f64 + 0.5) * SIDE / PIXELS as f64;
    DVec2::new(at(pixel % PIXELS), at(pixel / PIXELS))
}

/// The first pixel whose centre is on the other side, of the first, the middle and the last of every run.
fn difference(case: &Case) -> Option<String> {
    let runs = runs(case.picture);
    let count: usize = runs.iter().map(|run| run.1).sum();
    assert_eq!(count, PIXELS * PIXELS, "{}", case.name);
    let pixels = |&(start, count, kind): &(usize, usize, char)| {
        [0, count / 2, count - 1].map(|k| (centre(start + k), kind == '#'))
    };
    let known = runs.iter().filter(|run| run.2 != '?').flat_map(pixels);
    let is_wrong = |&(p, inside): &_| case.stroke.contains(p, FillRule::NonZero) != inside;
    let (p, inside) = known.into_iter().find(is_wrong)?;
    Some(format!("{}: at {p} expected {inside}", case.name))
}

#[test]
fn pictures_of_resvg() {
    let lines = include_str!("../data/strokes/resvg.txt").lines();
    let lines: Vec<&str> = lines.filter(|line| !line.starts_with("# ")).collect();
    assert_eq!(lines.len(), 30);
    let wrong = lines.iter().filter_map(|line| difference(&read(line)));
    let wrong: Vec<String> = wrong.collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
