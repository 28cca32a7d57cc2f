//! Lines, quadratics and cubics that are `Copy`: every method has the result of the same method of `Curve`.

use crate::support::{Rng, Space};
use casteljau::Curve;
use casteljau::curve::{Cubic, Line, Quad};
use casteljau::glam::{DAffine2, DVec2, DVec3, dvec2};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Compares a curve of a fixed degree with the same curve of any degree.
macro_rules! same {
    ($type:ident, $points:expr, $t:expr, $p:expr) => {{
        let copy = $type::try_from($points).expect("finite points");
        let curve = Curve::from(copy);
        let (t, p) = ($t, $p);
        assert_eq!(curve.control_points(), copy.control_points());
        assert_eq!((copy.start(), copy.end()), (curve.start(), curve.end()));
        assert_eq!($type::try_from(&curve), Ok(copy));
        assert_eq!($type::try_from(curve.clone()), Ok(copy));
        assert_eq!(copy.eval(t), curve.eval(t));
        for (part, of_curve) in [
            (copy.split(t), curve.split(t)),
            (copy.halve(), curve.halve()),
        ] {
            assert_eq!(Curve::from(part.0), of_curve.0, "{t}");
            assert_eq!(Curve::from(part.1), of_curve.1, "{t}");
        }
        assert_eq!(
            Curve::from(copy.subsegment(t..0.75)),
            curve.subsegment(t..0.75)
        );
        assert_eq!(Curve::from(copy.reverse()), curve.reverse());
        assert_eq!(copy.bounds(), curve.bounds());
        assert_eq!(copy.length(), curve.length());
        assert_eq!(copy.nearest(p), curve.nearest(p));
        let tolerance = 0.01 * (1.0 + copy.bounds().diagonal());
        assert_eq!(copy.flatten(tolerance), curve.flatten(tolerance));
        assert_eq!(
            (copy.tangent(t), copy.normal(t)),
            (curve.tangent(t), curve.normal(t))
        );
        assert_eq!(copy.curvature(t).to_bits(), curve.curvature(t).to_bits());
        assert_eq!(copy.derivative_at(t, 2), curve.derivative_at(t, 2));
        assert_eq!(copy.control_bounds(), curve.control_bounds());
        assert_eq!(copy.extrema(1), curve.extrema(1));
        assert_eq!(
            copy.times_at_coordinate(0, 0.25),
            curve.times_at_coordinate(0, 0.25)
        );
        let half = 0.5 * copy.length();
        assert_eq!(
            copy.length_within(tolerance),
            curve.length_within(tolerance)
        );
        assert_eq!(copy.time_at_length(half), curve.time_at_length(half));
        assert_eq!(copy.point_at_length(half), curve.point_at_length(half));
        assert_eq!(copy.equidistant_times(3), curve.equidistant_times(3));
        assert_eq!(copy.sample(4), curve.sample(4));
        copy
    }};
}

fn check<P: Space>(rng: &mut Rng) {
    let mut point = || {
        let [x, y, z] = [0, 1, 2].map(|_| rng.signed() * rng.pick(&[1.0, 1e-9, 1e100]));
        P::of(DVec3::new(x, y, z))
    };
    let points = [point(), point(), point(), point()];
    let p = point();
    let t = rng.pick(&[0.0, 0.3, 1.0, -0.5, 1.5, 0.999]);
    let [a, b, c, _] = points;
    let line = same!(Line, [a, b], t, p);
    let quad = same!(Quad, [a, b, c], t, p);
    let cubic = same!(Cubic, points, t, p);
    assert_eq!(line.derivative(), b - a);
    assert_eq!(
        Curve::from(quad.derivative()),
        Curve::from(quad).derivative()
    );
    assert_eq!(
        Curve::from(cubic.derivative()),
        Curve::from(cubic).derivative()
    );
    assert_eq!(Ok(Curve::from(quad.elevate())), Curve::from(quad).elevate());
}

#[test]
fn methods_are_those_of_curves() {
    let mut rng = Rng(3301);
    for _ in 0..300 {
        check::<DVec2>(&mut rng);
        check::<DVec3>(&mut rng);
    }
    let map = DAffine2::from_angle(1.0);
    let line = Line::new(DVec2::X, DVec2::Y).expect("finite");
    let image = line.transform(&map).map(Curve::from);
    assert_eq!(image, Curve::from(line).transform(&map));
}

#[test]
fn methods_of_the_plane_are_those_of_curves() {
    let points = [(0.0, 0.0), (3.0, 2.0), (-2.0, 2.0), (1.0, 0.0)].map(DVec2::from);
    let cubic = Cubic::try_from(points).expect("finite");
    let curve = Curve::from(cubic);
    assert_eq!(
        (cubic.area(), cubic.moments()),
        (curve.area(), curve.moments())
    );
    assert_eq!(cubic.self_intersections(), curve.self_intersections());
    assert_eq!(cubic.offset(0.25), curve.offset(0.25));
    assert_eq!(
        cubic.offset_within(0.25, 0.1),
        curve.offset_within(0.25, 0.1)
    );
    assert_eq!(cubic.to_svg(), curve.to_svg());
    let line = Line::new(dvec2(-1.0, 0.5), dvec2(2.0, 1.0)).expect("finite");
    let crossings = curve.intersections(&Curve::from(line));
    assert!(!crossings.is_empty());
    assert_eq!(cubic.intersections(line), crossings);
    assert_eq!(cubic.intersections(Curve::from(line)), crossings);
}

#[test]
fn the_longest_line_stays_within_the_limit() {
    let largest = dvec2(casteljau::MAX_COORDINATE, 0.0);
    let huge = Line::new(-largest, largest).expect("within the limit");
    assert!(huge.split(10.0).0.end().is_finite());
    assert_eq!(huge.derivative(), largest);
}
