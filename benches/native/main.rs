//! The native benchmarks, compared with other crates: `cargo bench`.
//!
//! Every group first checks that all libraries give the same results. The table of `npm run bench` shows the medians.

mod curves;
mod flatten;
mod forms;
mod inputs;
mod intersect;
mod length;
mod nearest;
mod offset;
mod rational;
mod regions;
mod simplify;
mod stroke;
mod surfaces;
mod teapot;

use criterion::{Criterion, criterion_group, criterion_main};
use std::time::Duration;

criterion_group! {
    name = all;
    config = Criterion::default()
        .sample_size(30)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_millis(1500));
    targets = flatten::bench, curves::bench, intersect::bench, length::bench, forms::bench, nearest::bench, offset::bench, rational::bench, regions::bench, simplify::bench, stroke::bench, surfaces::bench, teapot::bench
}
criterion_main!(all);
