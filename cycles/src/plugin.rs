//! The plugin: what the emulator calls, and what it is asked for.
//!
//! ```sh
//! qemu-system-arm ... -plugin libcycles.so,core=m4,mark=0x1234
//! ```
//! `core` is whose table: `m0`, `m4` or `hazard3`. `mark` is the address of a function: a section of the program begins when it is called,
//! and ends when it is called again. For each section a line is printed, ahead of all that the program prints from then on:
//! ```text
//! cycles 1234
//! ```
//! The functions below are those of `include/qemu/qemu-plugin.h`, in the version that QEMU 4.2 to 8.2 have. Later ones refuse the
//! plugin, as they hand out the bytes of an instruction in another way.

use std::ffi::{c_char, c_int, c_uint, c_void, CStr};
use std::io::{stdout, Write};
use std::slice;
use std::sync::Mutex;

use crate::counter::{Counter, Step};
use crate::model::Core;

/// An opaque thing of the emulator.
#[repr(C)]
struct Opaque([u8; 0]);

type Block = Opaque;
type Code = Opaque;

/// `QEMU_PLUGIN_CB_NO_REGS`: a callback looks at no registers.
const NO_REGISTERS: c_int = 0;
/// `QEMU_PLUGIN_MEM_RW`: loads and stores.
const LOADS_AND_STORES: c_int = 3;

unsafe extern "C" {
    fn qemu_plugin_register_vcpu_tb_trans_cb(id: u64, callback: extern "C" fn(u64, *mut Block));
    fn qemu_plugin_tb_n_insns(block: *const Block) -> usize;
    fn qemu_plugin_tb_get_insn(block: *const Block, index: usize) -> *mut Code;
    fn qemu_plugin_insn_data(code: *const Code) -> *const u8;
    fn qemu_plugin_insn_size(code: *const Code) -> usize;
    fn qemu_plugin_insn_vaddr(code: *const Code) -> u64;
    fn qemu_plugin_register_vcpu_insn_exec_cb(
        code: *mut Code,
        callback: extern "C" fn(c_uint, *mut c_void),
        flags: c_int,
        data: *mut c_void,
    );
    fn qemu_plugin_register_vcpu_mem_cb(
        code: *mut Code,
        callback: extern "C" fn(c_uint, u32, u64, *mut c_void),
        flags: c_int,
        accesses: c_int,
        data: *mut c_void,
    );
    fn qemu_plugin_mem_size_shift(access: u32) -> c_uint;
}

/// The version of the interface: the emulator reads it before it calls anything.
#[unsafe(no_mangle)]
#[allow(non_upper_case_globals, reason = "its name is given")]
pub(crate) static qemu_plugin_version: c_int = 1;

struct Plugin {
    core: Core,
    counter: Counter,
    /// Where sections begin and end.
    mark: u64,
}

/// One processor, so nobody ever waits for it.
static PLUGIN: Mutex<Plugin> = Mutex::new(Plugin { core: Core::M4, counter: Counter::new(Core::M4), mark: 0 });

fn with(work: impl FnOnce(&mut Plugin)) {
    // Nothing in here panics while it is locked.
    if let Ok(mut plugin) = PLUGIN.lock() {
        work(&mut plugin);
    }
}

/// The emulator calls this first. Anything but 0 ends it.
///
/// # Safety
/// `arguments` are `count` strings that end with zero: those after the name of the plugin.
#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn qemu_plugin_install(
    id: u64,
    _: *const c_void,
    count: c_int,
    arguments: *const *const c_char,
) -> c_int {
    let mut set = Ok(());
    for at in 0..usize::try_from(count).unwrap_or(0) {
        // SAFETY: the caller says so.
        let argument = unsafe { CStr::from_ptr(*arguments.add(at)) }.to_string_lossy();
        with(|plugin| set = std::mem::replace(&mut set, Ok(())).and_then(|()| plugin.set(&argument)));
    }
    if let Err(wrong) = set {
        eprintln!("plugin: what is `{wrong}`?");
        return 1;
    }
    // SAFETY: `id` is ours, and the callback stays loaded.
    unsafe { qemu_plugin_register_vcpu_tb_trans_cb(id, translated) };
    0
}

impl Plugin {
    fn set(&mut self, argument: &str) -> Result<(), String> {
        let wrong = || argument.to_owned();
        match argument.split_once('=').ok_or_else(wrong)? {
            ("core", "m0") => self.core = Core::M0,
            ("core", "m4") => self.core = Core::M4,
            ("core", "hazard3") => self.core = Core::Hazard3,
            ("mark", mark) => {
                let digits = mark.strip_prefix("0x").ok_or_else(wrong)?;
                self.mark = u64::from_str_radix(digits, 16).map_err(|_| wrong())?;
            }
            _ => return Err(wrong()),
        }
        self.counter = Counter::new(self.core);
        Ok(())
    }
}

/// A block of code was translated: asks to be told of each of its instructions.
extern "C" fn translated(_: u64, block: *mut Block) {
    // SAFETY: a block of the emulator's, for the time of this call.
    for index in 0..unsafe { qemu_plugin_tb_n_insns(block) } {
        // SAFETY: there is an instruction of this index; its bytes are there for the time of this call.
        let (code, address, bytes) = unsafe {
            let code = qemu_plugin_tb_get_insn(block, index);
            let bytes = slice::from_raw_parts(qemu_plugin_insn_data(code), qemu_plugin_insn_size(code));
            (code, qemu_plugin_insn_vaddr(code), bytes)
        };
        let half = |at: usize| bytes.get(at..at + 2).map_or(0, |half| u16::from_le_bytes([half[0], half[1]]));
        let mut table = Core::M4;
        with(|plugin| table = plugin.core);
        let (instruction, size) = table.decode(half(0), half(2));
        let step = Step { address, size, instruction };
        // It lives as long as the emulator, which may run the block at any time. There are as many as the program has
        // instructions.
        let step: *mut Step = Box::leak(Box::new(step));
        // SAFETY: the callbacks stay loaded and `step` is never freed.
        unsafe {
            qemu_plugin_register_vcpu_insn_exec_cb(code, started, NO_REGISTERS, step.cast());
            let data = std::ptr::null_mut();
            qemu_plugin_register_vcpu_mem_cb(code, accessed, NO_REGISTERS, LOADS_AND_STORES, data);
        }
    }
}

extern "C" fn started(_: c_uint, step: *mut c_void) {
    // SAFETY: it was made above, and nobody writes to it.
    let step = unsafe { &*step.cast::<Step>() };
    with(|plugin| {
        if step.address == plugin.mark {
            if let Some(cycles) = plugin.counter.mark(*step) {
                let mut out = stdout().lock();
                // The tool misses the line when it cannot be written.
                let _ = writeln!(out, "cycles {cycles}").and_then(|()| out.flush());
            }
        } else {
            plugin.counter.start(*step);
        }
    });
}

extern "C" fn accessed(_: c_uint, access: u32, address: u64, _: *mut c_void) {
    // SAFETY: it only looks at its argument.
    let shift = unsafe { qemu_plugin_mem_size_shift(access) };
    with(|plugin| plugin.counter.access(address, shift));
}
