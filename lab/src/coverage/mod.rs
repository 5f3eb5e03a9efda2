//! Soft rims: what a shape covers of each pixel, as this crate finds it and as the peers do, against exact areas; what that costs; and
//! how bright thin lines are at any angle.
//!
//! ```text
//!  outline, paths            what is filled, as each of the peers wants it
//!    |
//!  shape                     the same, prepared for everybody
//!    |
//!  engine, peers             one entry for each way: a mask of 320 x 240 levels
//!    |
//!  Family::run               as for all other shapes: instructions, time, and the judge
//!    |
//!  judge, truth              the level of each pixel against its area
//!    |          angles       sums of levels along lines, degree by degree
//!    |            |
//!  page                      docs/coverage.md and its plots
//!
//!  stores                    multiples of the time of a loop that stores as many bytes
//! ```

pub(crate) mod angles;
mod engine;
mod judge;
mod outline;
pub(crate) mod page;
#[cfg(feature = "peers-aa")]
mod paths;
#[cfg(feature = "peers-aa")]
mod peers;
mod shape;
pub(crate) mod stores;
mod truth;
mod workload;

use self::shape::Soft;
use crate::{bench::Family, engine::Entry};

/// What an engine leaves: 255ths of each pixel of the screen, in reading order.
pub(crate) type Levels = Vec<u8>;

pub(crate) type Ways = Vec<Entry<Soft, Levels>>;

/// All ways: this crate's, and those of the peers that were compiled.
fn entries() -> Ways {
    #[cfg(feature = "peers-aa")]
    return engine::entries().into_iter().chain(peers::entries()).collect();
    #[cfg(not(feature = "peers-aa"))]
    engine::entries()
}

/// Fills, and lines one pixel wide.
pub(crate) fn coverage(quick: bool) -> Family<Soft> {
    Family { key: "coverage", title: "Coverage", entries: entries(), workloads: workload::all(quick) }
}
