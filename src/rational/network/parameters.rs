//! Common parameters of patches whose edges are one curve.
//!
//! The weights wᵢ and wᵢ ρⁱ give the same points; t/(1 − t) is multiplied by a constant. So a patch has a free factor for its
//! weights along u and one along v, and an edge that is the same curve in two patches links two of these factors.

use super::RationalSurface;
use super::mesh::{MAX_QUOTIENT, quotient};
use crate::numeric::list::Scalars;
use crate::rational::check_weights;
use crate::rational::split::nth_root;
use crate::surface::topology::SIDES;
use std::collections::VecDeque;
use std::iter::successors;

/// A factor is `ratio` times another one, or `ratio` divided by it if their directions differ.
#[derive(Clone, Copy)]
struct Link {
    to: usize,
    ratio: f64,
    reversed: bool,
}

impl Link {
    /// The factor that belongs to another one.
    fn apply(&self, factor: f64) -> f64 {
        if self.reversed {
            self.ratio / factor
        } else {
            self.ratio * factor
        }
    }
}

impl RationalSurface {
    /// The same points with other parameters of patches, so that open edges that are the same curve have weights in proportion.
    ///
    /// The first factor of a chain of linked ones is 1. Of a closed chain that needs two factors, the edge farthest from the first one is
    /// left. All patches that common curves connect change, or none.
    pub(crate) fn with_common_parameters(mut self) -> Self {
        let weights = self.edge_weights();
        let lines = self.uses_of(&weights);
        let rates: Vec<f64> = weights.iter().map(rate).collect();
        let standard: Vec<Scalars> = weights.iter().zip(&rates).map(standard_form).collect();
        let curves = self.uses_of(&standard);
        if curves == lines {
            return self;
        }
        let mut uses = vec![0; lines.len()];
        lines.iter().for_each(|line| uses[line.first] += 1);
        let mut first_open = vec![None; curves.len()];
        let mut links: Vec<Vec<Link>> = vec![Vec::new(); 2 * self.patch_count()];
        for (edge, (line, curve)) in lines.iter().zip(&curves).enumerate() {
            let (first, reversed, ratio) = if uses[line.first] > 1 {
                (line.first, line.reversed, 1.0)
            } else {
                let first = *first_open[curve.first].get_or_insert(edge);
                let reversed = curve.reversed != curves[first].reversed;
                let inverse = if reversed {
                    1.0 / rates[first]
                } else {
                    rates[first]
                };
                (first, reversed, rates[edge] / inverse)
            };
            if first == edge || line.collapsed {
                continue;
            }
            let [to, from] = [edge, first].map(factor_along);
            let back = if reversed { ratio } else { 1.0 / ratio };
            links[from].push(Link {
                to,
                ratio,
                reversed,
            });
            links[to].push(Link {
                to: from,
                ratio: back,
                reversed,
            });
        }
        let factors = factors(&links);
        for part in self.network.topology_of(&curves).components {
            let changed: Option<Vec<Vec<f64>>> = part
                .iter()
                .map(|&patch| self.multiplied(patch, &factors[2 * patch..]))
                .collect();
            for (&patch, weights) in part.iter().zip(changed.iter().flatten()) {
                let range = self.network.net_range(patch);
                self.weights[range].copy_from_slice(weights);
            }
        }
        self
    }

    /// The weights of a patch times powers of two factors; `None` if they would differ too much, or leave the range of weights.
    fn multiplied(&self, patch: usize, factors: &[f64]) -> Option<Vec<f64>> {
        let weights = self.patch_weights(patch)?;
        let [m, n] = self.degrees(patch)?;
        let [along_u, along_v] = [powers(factors[0], m), powers(factors[1], n)];
        let rows = weights.chunks(m + 1).zip(&along_v);
        let changed: Vec<f64> = rows
            .flat_map(|(row, v)| row.iter().zip(&along_u).map(move |(w, u)| w * u * v))
            .collect();
        check_weights(&changed, weights.len()).ok()?;
        (quotient(&changed) <= MAX_QUOTIENT.max(quotient(weights))).then_some(changed)
    }
}

/// The number of the factor of the weights along an edge: u is 2 · patch, v the next one.
fn factor_along(edge: usize) -> usize {
    2 * (edge / SIDES) + usize::from(edge % SIDES < 2)
}

/// The factors that links require, in the order of their distance from the first one, which is 1.
fn factors(links: &[Vec<Link>]) -> Vec<f64> {
    let mut factors = vec![None; links.len()];
    let mut queue = VecDeque::new();
    for start in 0..links.len() {
        if factors[start].is_none() {
            queue.push_back((start, 1.0));
        }
        while let Some((node, factor)) = queue.pop_front() {
            if factors[node].is_some() {
                continue;
            }
            factors[node] = Some(factor);
            queue.extend(links[node].iter().map(|link| (link.to, link.apply(factor))));
        }
    }
    factors.into_iter().flatten().collect()
}

/// The number ρ for which the weights wᵢ ρⁱ have equal ends.
fn rate(weights: &Scalars) -> f64 {
    let last = weights.len() - 1;
    nth_root(weights[0] / weights[last], last)
}

/// The weights wᵢ ρ^(i − n/2) for that number: the same for all weights of a curve, except for a common factor. They are in the range
/// of f64, and those of the reversed curve are reversed.
fn standard_form((weights, rate): (&Scalars, &f64)) -> Scalars {
    let last = weights.len() - 1;
    let powers = powers(rate.sqrt(), last);
    let scaled = weights.iter().enumerate().map(|(i, w)| {
        if 2 * i < last {
            w / powers[last - 2 * i]
        } else {
            w * powers[2 * i - last]
        }
    });
    scaled.collect()
}

/// xⁱ for i up to n.
fn powers(x: f64, n: usize) -> Vec<f64> {
    successors(Some(1.0), |power| Some(power * x))
        .take(n + 1)
        .collect()
}
