//! Workloads, engines that draw them, and the table of what they cost.
//!
//! ```text
//!  scene          what is drawn: data, the same for every engine
//!    |
//!  engine         a set of functions, one per kind of workload
//!    |            own: this crate;  eg: embedded-graphics' own framebuffer;  bound: hand-written loops
//!  report         one line per workload, format and engine
//! ```
//! An engine more is one file with its functions in a constant [`engine::Engine`], and one call of
//! [`report::print`] in `bin/table.rs`.
#![no_std]

pub mod bound;
pub mod eg;
pub mod engine;
pub mod own;
pub mod report;
pub mod scene;
pub mod soft;
