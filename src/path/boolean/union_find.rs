//! Sets of numbers that can be united. Source: Tarjan, "Efficiency of a good but not linear set union algorithm" (1975).

/// Disjoint sets of the numbers from 0; the smallest of a set stands for it.
pub(super) struct UnionFind {
    parents: Vec<usize>,
}

impl UnionFind {
    /// Sets of one number each.
    pub(super) fn new(count: usize) -> Self {
        Self {
            parents: (0..count).collect(),
        }
    }

    /// Adds the set of the next number.
    pub(super) fn add(&mut self) -> usize {
        self.parents.push(self.parents.len());
        self.parents.len() - 1
    }

    /// The smallest number of a set.
    pub(super) fn find(&mut self, mut k: usize) -> usize {
        while self.parents[k] != k {
            self.parents[k] = self.parents[self.parents[k]];
            k = self.parents[k];
        }
        k
    }

    /// Unites two sets.
    pub(super) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        self.parents[a.max(b)] = a.min(b);
    }
}
