//! Outlines with half-edges around a vertex whose order the directions at the vertex do not show.

use crate::path_boolean::check::{identity_error, path, valid};
use crate::support::near;
use crate::support::paths::{closed, points};
use casteljau::glam::{DAffine2, DVec2};
use casteljau::path::FillRule;
use casteljau::{Path, Spline};

const RULE: FillRule = FillRule::NonZero;

#[test]
fn loops_that_leave_a_corner_in_similar_directions() {
    // The second loop is the first, scaled by 1/3 about the corner where both start, and so a region within it.
    let corner = DVec2::new(8.221404925779842, -8.785055879304679);
    let first = path(
        "M8.221404925779842,-8.785055879304679 C-12.570536490619254,2.748715308359417 \
         -18.63642500706652,6.079246895820287 8.221404925779842,-8.785055879304679 Z",
    );
    let at_origin = DAffine2::from_translation(-corner) * &first;
    let smaller = DAffine2::from_scale(DVec2::splat(1.0 / 3.0)) * &at_origin;
    let second = DAffine2::from_translation(corner) * &smaller;
    let both = valid(first.exclude(&second, RULE));
    near(both.area() / first.area(), 8.0 / 9.0, 1e-9);
    let union = valid(first.union(&second, RULE));
    near(union.area() / first.area(), 1.0, 1e-9);
    // A contour in the other direction is a hole.
    let hole = path(&format!("{first} {}", second.reverse()));
    let ring = valid(hole.remove_overlaps(RULE));
    near(ring.area() / first.area(), 8.0 / 9.0, 1e-9);
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
    let degree_4 = points(
        "0.4916497247590126 -0.785602794865385  0.4851573054795739 0.7607219303371188
         -0.9066851873104919 0.9985119866212783  -0.38467749642579907 0.752354957334188
         -0.04232622558270793 0.03490315173661407  0.7805413364478846 -0.6489567267722063
         0.3134382008291139 -0.3740641437211203  -0.9614093238985751 0.24436292939385537
         0.09773936883923207 0.8808440254628277  -0.6637301145914972 -0.1154686617283085
         0.6061353797695794 -0.4326966398820702  0.44784692090824807 0.842100855095324",
    );
    let a = closed(&degree_4, 4);
    let b = DAffine2::from_angle(9.948057441366842e-06) * &a;
    let error = identity_error(&a, &b, FillRule::EvenOdd);
    assert!(error < 1e-12, "areas differ by {error:e}");
}

#[test]
fn a_loop_whose_ends_leave_a_vertex_in_the_same_direction() {
    // Sizes from 1e-12 to 1e15. The first segment is a loop with its start and end within 1e-10 of its size, in
    // directions that are equal within rounding, at the joint of the others.
    let first = "0.0009064175852028227 5.050903042555853e-12  1 -0.00035661475297452073
         -1 -9.685524485084386e-11  0 -88360961.58268085
         -16062911.161131354 1678436145722.2163
         1000000000000000 -1.5019787082304275e-6
         0.006841905289156387 -10452.882042673176
         2337147.3487787186 -1000000000010452.9  2.092605713328062 -10453.882042673176
         2.0918928146216604 -10452.882042612979  4809375762492.081 233784424077528.03
         -12316713247902.18 -10452.882042673176  2.0926057238165408 -10452.882042671146
         -17963471646.858135 46774033710680.05  3.0926057335371917 46774032410126.07
         -253228.49310127975 46774032410125.07  27942.35259511652 46774032410126.07
         3.0926057335371917 46774032410126.07  1.0926057335371917 46774032410126.07";
    let second = "52112.87294588847 8835.358787775469  52112.87294588847 8835.358787775469
         56321.071498080055 -1.3499566608102154  56321.14023024132 -1.3499734297577406
         56321.07149768608 -5720578542793.3545  56321.07150216006 -5720578542793.3545
         56321.07150222009 -5720578542793.3545  56321.07150221806 -5720578542793.3545
         56321.07150195831 -5720578542793.3545  56321.07150221677 -5720578542793.3545
         56321.07149850251 -5720578542793.3545";
    let path = [
        subpath(first, &[6, 6, 6], false),
        subpath(second, &[2, 2, 6], false),
    ];
    assert_region_is_exact(&path.into_iter().collect());
}

#[test]
fn a_component_beside_a_sliver_is_not_in_it() {
    // Sizes from 1e-9 to 2e15. The ray from the third subpath meets both sides of the second one, a sliver, at distances
    // that are equal within rounding.
    let first = "-1.6306650922589486e-5 2.5835187980986506e-8
         9.234839688061331e-8 2.654520881241142e-9
         1.203353734545253e-6 -7.454283027794643e-9
         9.234839688061331e-8 2.654520881241142e-9
         1.203353734545253e-6 -7.454283027794643e-9
         1.2033548455505907e-6 -7.454293136598553e-9
         -830.6572689323395 562.8004705210127  -391552.4451909353 265291.0028442511
         16769.95884255974 -11362.256191449293  249714.36399585492 -169190.5512562594
         -1074.0849991169002 727.7315994493193  -563.7705551366142 381.9750285114364
         221838.22495251778 -150303.45502952163  221740.20903909556 -149853.15628070527
         221845.01090878688 -150334.6306571398  221833.5522882105 -150281.98815931933
         220968.64195157267 -146308.46968840846  219983.20555242948 -141781.23771067007
         221844.7234843843 -150333.31018942865  221844.6789068752 -150333.1053941471";
    let second = "-132968590.77629173 86.15899715674215  -1 1.0094076322693548e-6
         -28.169560867067197 0  715608303326283.1 -15103184.821569175
         715608305797789.8 -17108757.168408558  715608303336808.3 -15111725.775251662
         715608306648975.1 -17799475.064864963";
    let third = "178731431.21496683 4436165.187538288  -15988083869.327383 -1
         -70.17113384485445 -1  1000000000000000 1000000000000000
         999958376492440.6 2000071223171301.5  1000000000808046 2000000000000000
         1002660891147741.5 2000000000000000";
    let path = [
        subpath(first, &[4, 8, 8], true),
        subpath(second, &[3, 3], false),
        subpath(third, &[3, 3], false),
    ];
    assert_region_is_exact(&path.into_iter().collect());
}

#[test]
fn an_arc_that_starts_at_the_other_side_of_its_vertex() {
    // Sizes from 1e-13 to 1e15. The second subpath returns to the first point from the other side, and ends within the
    // tolerance beyond it: there its direction is not the one in which it leaves the vertex.
    let first = "0.00015254773369358075 -40653.943271628734  0 196965312319165.78
         -1725574.3926403914 0  0 7.442954584737852e-12
         0.014866406686166608 19517.93300287041  2.559952744141234e-7 1
         727118279706998.4 -441.768668030475
         -0.0020360744083726483 0.0010897450663965623  -179813.21890620835 0
         -179813.39871942523 -1.0897450663965622e-9";
    let second = "-5.277276385018363e-9 -1000000000000000  2428905478174.439 -333333333333333.4
         1943124382539.5513 -66666666666667.06  728671625473.9419 -5006.992597881812
         -47942.37286545761 -13350.713594252888  -59927.96608247876 -16687.64199281611
         2.18060942982485e-9 1";
    let path = [subpath(first, &[8, 2], true), subpath(second, &[6], false)];
    assert_region_is_exact(&path.into_iter().collect());
}

/// A spline, closed by a line if it is open.
fn subpath(text: &str, degrees: &[usize], closed: bool) -> Spline<DVec2> {
    let mut points = points(text);
    let mut degrees = degrees.to_vec();
    if !closed {
        points.push(points[0]);
        degrees.push(1);
    }
    Spline::with_degrees(points, &degrees, closed).expect("valid points")
}

/// The region has the winding number 1 where that of the path is not 0, at samples in the box of each contour: contours
/// may be small in the box of the path.
fn assert_region_is_exact(path: &Path) {
    let region = valid(path.remove_overlaps(RULE));
    // Outlines closer together than ε count as one.
    let clear = 1e-8 * path.bounds().expect("points").diagonal();
    let mut inside = 0;
    for bounds in region.subpaths().map(|contour| contour.bounds()) {
        for k in 0..40 * 40 {
            let part = DVec2::new(f64::from(k % 40) + 0.5, f64::from(k / 40) + 0.5) / 40.0;
            let p = bounds.min + (bounds.max - bounds.min) * part;
            let nearest = path.nearest(p).expect("finite").expect("a segment");
            if nearest.distance < clear {
                continue;
            }
            let expected = i32::from(path.winding_number(p) != 0);
            assert_eq!(region.winding_number(p), expected, "{p}");
            inside += expected;
        }
    }
    assert!(inside > 100, "{inside}");
}
