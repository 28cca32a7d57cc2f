//! Boolean operations of paths: judged by winding numbers of densely sampled outlines, by identities of areas, and by
//! what a result promises.

mod check;
mod families;
mod known;
mod large;
mod oracle;
mod order;
mod promises;
mod suites;
mod sweep;
