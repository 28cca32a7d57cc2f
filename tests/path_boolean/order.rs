//! Outlines with half-edges around a vertex whose order the directions at the vertex do not show.

use crate::check::{identity_error, path, valid};
use casteljau::glam::{DAffine2, DVec2};
use casteljau::path::FillRule;
use casteljau::{Curve, Path, Spline};

const RULE: FillRule = FillRule::NonZero;

#[test]
fn loops_that_leave_a_corner_in_similar_directions() {
    // The second loop is the first, scaled by 1/3 about the corner where both start, and so a region within it.
    let corner = DVec2::new(8.221404925779842, -8.785055879304679);
    let first = path(
        "M8.221404925779842,-8.785055879304679 C-12.570536490619254,2.748715308359417 \
         -18.63642500706652,6.079246895820287 8.221404925779842,-8.785055879304679 Z",
    );
    let second = first
        .transform(&DAffine2::from_translation(-corner))
        .transform(&DAffine2::from_scale(DVec2::splat(1.0 / 3.0)))
        .transform(&DAffine2::from_translation(corner));
    let both = valid(first.exclude(&second, RULE));
    assert_close(both.area() / first.area(), 8.0 / 9.0);
    let union = valid(first.union(&second, RULE));
    assert_close(union.area() / first.area(), 1.0);
    // A contour in the other direction is a hole.
    let hole = path(&format!("{first} {}", second.reverse()));
    let ring = valid(hole.remove_overlaps(RULE));
    assert_close(ring.area() / first.area(), 8.0 / 9.0);
}

#[test]
fn arcs_that_turn_sharply_beside_a_vertex() {
    // Slivers: there and back along almost the same curve. The second one crosses itself 1e-4 before it turns, on a
    // radius of 3e-7; the first one crosses both of its sides.
    let a = path(
        "M0.28829966860790934,0.6503771693546795 \
         C0.39712746904395463,0.5972898072894897 0.7145145310192041,0.7880964108380881 0.6056867305831588,0.8411837729032781 \
         C0.7145144952094165,0.7880964704039684 0.39712743323416705,0.5972898668553698 0.28829966860790934,0.6503771693546795 Z",
    );
    let b = path(
        "M0.375422448439104,0.7429895442513299 \
         C-0.08489010041743761,1.038635222465357 0.30994913715053674,0.7861305662494833 0.7702616860070783,0.4904848880354562 \
         C0.3099491611126277,0.7861306037187873 -0.08489007645534662,1.038635259934661 0.375422448439104,0.7429895442513299 Z",
    );
    let error = identity_error(&a, &b, FillRule::EvenOdd);
    assert!(error < 1e-12, "areas differ by {error:e}");
}

#[test]
fn arcs_that_turn_back_near_their_end() {
    // A closed outline of degree 4 and itself, turned by 1e-5.
    let degree_4 = [
        [
            DVec2::new(0.4916497247590126, -0.785602794865385),
            DVec2::new(0.4851573054795739, 0.7607219303371188),
            DVec2::new(-0.9066851873104919, 0.9985119866212783),
            DVec2::new(-0.38467749642579907, 0.752354957334188),
            DVec2::new(-0.04232622558270793, 0.03490315173661407),
        ],
        [
            DVec2::new(-0.04232622558270793, 0.03490315173661407),
            DVec2::new(0.7805413364478846, -0.6489567267722063),
            DVec2::new(0.3134382008291139, -0.3740641437211203),
            DVec2::new(-0.9614093238985751, 0.24436292939385537),
            DVec2::new(0.09773936883923207, 0.8808440254628277),
        ],
        [
            DVec2::new(0.09773936883923207, 0.8808440254628277),
            DVec2::new(-0.6637301145914972, -0.1154686617283085),
            DVec2::new(0.6061353797695794, -0.4326966398820702),
            DVec2::new(0.44784692090824807, 0.842100855095324),
            DVec2::new(0.4916497247590126, -0.785602794865385),
        ],
    ]
    .map(|points| Curve::new(&points).expect("five points"));
    let a = Path::from(Spline::from_curves(&degree_4, true).expect("a closed outline"));
    let b = a.transform(&DAffine2::from_angle(9.948057441366842e-06));
    let error = identity_error(&a, &b, FillRule::EvenOdd);
    assert!(error < 1e-12, "areas differ by {error:e}");
}

fn assert_close(actual: f64, expected: f64) {
    assert!(
        (actual - expected).abs() <= 1e-9,
        "expected {expected}, got {actual}"
    );
}
