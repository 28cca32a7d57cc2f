use casteljau::glam::DVec2;
use casteljau::path::FillRule;
use casteljau::spline::Interpolation;
use casteljau::{Easing, Path, Spline};

pub(crate) fn sample(out: &mut String) {
    // Animation: which share of the way is done after which share of the time?
    let in_out = Easing::new(0.42, 0.0, 0.58, 1.0).unwrap();
    let values = [0.0, 0.25, 0.5, 0.75, 1.0].map(|x| format!("{:.3}", in_out.eval(x)));
    writeln!(out, "ease-in-out: {}", values.join(" "));

    // A camera flies through four points at constant speed. The steps of t are not equal.
    let stops = [(60.0, 380.0), (170.0, 110.0), (420.0, 90.0), (610.0, 300.0)];
    let way = Spline::interpolate(&stops.map(DVec2::from), Interpolation::Natural, false).unwrap();
    let ts: Vec<String> = way
        .equidistant_times(4)
        .unwrap()
        .iter()
        .map(|t| format!("{t:.3}"))
        .collect();
    writeln!(out, "each a quarter of the way: t = {}", ts.join(" "));

    // A letter is an outline of curves. Is a point inside? What is its bounding box?
    let o = Path::from_svg("M 50 10 C 90 10 90 90 50 90 S 10 10 50 10 Z").unwrap();
    let inside = |x, y| o.contains(DVec2::new(x, y), FillRule::NonZero);
    let (center, outer) = (inside(50.0, 50.0), inside(85.0, 15.0));
    writeln!(out, "o: {center}, outside: {outer}");
    let (min, max) = (o.bounds().unwrap().min, o.bounds().unwrap().max);
    writeln!(out, "box from {min} to {max}");
}
