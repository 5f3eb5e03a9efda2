//! Values over triangles: colours, depths, places in a texture. What a pixel costs, and how far its value is from the exact one.
//!
//! ```text
//!  textbook, this crate, peers     engine, peers: one entry for each way
//!    |
//!  Family::run                     as for all other shapes: instructions, time, and the judge below
//!    |
//!  judge                           the value of each pixel against a ratio of wide integers
//!    |                  chips      modelled cycles of the same ways on Cortex-M4 and Cortex-M0+
//!    |                    |
//!  page                            docs/shading.md and its plot
//! ```

pub(crate) mod chips;
pub(crate) mod engine;
pub(crate) mod judge;
pub(crate) mod page;
#[cfg(feature = "peers-3d")]
mod peers;
pub(crate) mod samples;
pub(crate) mod stores;
pub(crate) mod workload;

use textbook::scene::Triangle;

use crate::{bench::Family, engine::Entry};

/// What an engine leaves: a number for each pixel of the screen, in reading order; [`UNPAINTED`] where there is none.
pub(crate) type Drawn = Vec<u32>;

pub(crate) const UNPAINTED: u32 = u32::MAX;

/// What changes over a triangle.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Red, green and blue of RGB565.
    Levels,
    /// A depth, and a colour with it.
    Depth,
    /// A place in a texture, in perspective.
    Texels,
}

/// A triangle, and what is asked of it.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Shaded {
    pub(crate) kind: Kind,
    pub(crate) corners: Triangle,
}

pub(crate) type Ways = Vec<Entry<Shaded, Drawn>>;

#[cfg(feature = "peers-3d")]
fn with_peers(mut entries: Ways, which: fn(engine::Peers) -> Ways) -> Ways {
    entries.extend(which(peers::all()));
    entries
}

/// A lab without peers.
#[cfg(not(feature = "peers-3d"))]
fn with_peers(entries: Ways, _: fn(engine::Peers) -> Ways) -> Ways {
    entries
}

pub(crate) fn gouraud(quick: bool) -> Family<Shaded> {
    let (entries, workloads) = (with_peers(engine::gouraud(), |peers| peers.gouraud), workload::gouraud(quick));
    Family { key: "gouraud", title: "Colours", entries, workloads }
}

pub(crate) fn depth16(quick: bool) -> Family<Shaded> {
    let (entries, workloads) = (with_peers(engine::depth16(), |peers| peers.depth16), workload::depth(quick, 16));
    Family { key: "depth16", title: "Depths of 16 bits", entries, workloads }
}

pub(crate) fn depth32(quick: bool) -> Family<Shaded> {
    let (entries, workloads) = (with_peers(engine::depth32(), |peers| peers.depth32), workload::depth(quick, 32));
    Family { key: "depth32", title: "Depths of 32 bits", entries, workloads }
}

pub(crate) fn perspective(quick: bool) -> Family<Shaded> {
    let (entries, workloads) =
        (with_peers(engine::perspective(), |peers| peers.perspective), workload::perspective(quick));
    Family { key: "perspective", title: "Textures in perspective", entries, workloads }
}
