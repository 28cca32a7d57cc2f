//! Moving points: joined vertices stay joined, and no others become joined.

use super::networks;
use super::random::{check, options};
use super::shapes::{meshed, teapot, tolerance};
use super::soup::Soup;
use crate::support::nets::points;
use crate::support::{Rng, cases, changed};
use casteljau::Surface;
use casteljau::glam::DVec3;
use casteljau::mesh::Weld;

#[test]
fn topology_is_kept() {
    let mut rng = Rng(1975);
    for case in 0..cases(400, 4_000) {
        let surface = networks::random(&mut rng);
        let moved =
            (0..1 + rng.below(4)).fold(surface.clone(), |moved, _| move_one(&mut rng, &moved));
        assert_eq!(moved.topology(), surface.topology(), "case {case}");
        let options = options(&mut rng, &moved);
        let outcome = std::panic::catch_unwind(|| check(&moved, &surface, &options));
        assert!(outcome.is_ok(), "case {case}: {options:?} of {moved:?}");
    }
}

/// Moves a vertex to a random point nearby, or onto another vertex.
fn move_one(rng: &mut Rng, surface: &Surface) -> Surface {
    let vertices = surface.vertices();
    let (index, other) = (rng.below(vertices.len()), rng.below(vertices.len()));
    let size = surface.control_bounds().unwrap().diagonal();
    let by = size * rng.pick(&[0.0, 1.0]);
    let to = vertices[other] + rng.point(3) * by;
    changed(surface, |s| s.move_point(index, to)).unwrap()
}

#[test]
fn onto_another_point_and_away() {
    let surface = teapot();
    let expected = surface.topology();
    let mesh = |surface: &Surface| meshed(surface, tolerance(0.05), Weld::Position);
    let before = mesh(&surface);
    for (index, target) in [(0, 1), (3, 12), (40, 200), (289, 0)] {
        let home = surface.vertices()[index];
        let onto = surface.vertices()[target];
        let mut moved = surface.clone();
        moved.move_point(index, onto).unwrap();
        assert_eq!(moved.topology(), expected);
        Soup::new(&mesh(&moved)).assert_no_collapsed_triangle();
        moved.move_point(index, home).unwrap();
        assert_eq!(moved.topology(), expected);
        assert_eq!(mesh(&moved), before);
    }
}

/// A vertex that is listed twice moves as one vertex.
#[test]
fn copies_of_a_vertex_move_along() {
    let vertices = points("0 0 0  1 0 0  0 1 0  1 1 0  1 0 0  2 0 0  1 1 0  2 1 0");
    let surface = Surface::new(vertices, (0..8).collect(), 1, 1).unwrap();
    let topology = surface.topology();
    assert_eq!((topology.shared.len(), topology.open.len()), (1, 6));
    let to = DVec3::new(1.0, 0.0, 5.0);
    let moved = changed(&surface, |s| s.move_point(1, to)).unwrap();
    assert_eq!(moved.vertices()[4], DVec3::new(1.0, 0.0, 5.0));
    assert_eq!(moved.topology(), topology);
    // Moved onto a corner with which it was not joined: the edges remain separate.
    let to = surface.vertices()[1];
    let onto = changed(&surface, |s| s.move_point(0, to)).unwrap();
    assert_eq!(onto.topology(), topology);
    assert_eq!(onto.vertices()[4], onto.vertices()[0]);
}
