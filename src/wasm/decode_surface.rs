//! Decoding patches and surfaces from the arena.

use super::arena::Arena;
use crate::geometry::error::Error;
use crate::numeric::list::Net;
use crate::patch::Patch;
use crate::surface::network::Surface;

/// The patch whose net is at the start of the arena.
pub(crate) fn patch(a: &Arena, degree_u: usize, degree_v: usize) -> Patch {
    let net = a.points(0, (degree_u + 1) * (degree_v + 1));
    Patch::from_net(Net::from(net), degree_u + 1)
}

/// The surface at the start of the arena, and the index where it ends.
pub(crate) fn surface(a: &Arena) -> Result<(Surface, usize), Error> {
    let [vertices, patches, joined] = [0, 1, 2].map(|k| a.count(k));
    let degrees: Vec<[usize; 2]> = (0..patches)
        .map(|k| [a.count(3 + 2 * k), a.count(4 + 2 * k)])
        .collect();
    let at = 3 + 2 * patches;
    let indices_at = at + 3 * vertices;
    let net = |[u, v]: &[usize; 2]| (u + 1) * (v + 1);
    let joined_at = indices_at + degrees.iter().map(net).sum::<usize>();
    let surface = Surface::from_parts(
        a.points(at, vertices).to_vec(),
        a.small_counts(joined_at, joined),
        a.small_counts(indices_at, joined_at - indices_at),
        &degrees,
    )?;
    Ok((surface, joined_at + joined))
}
