//! Controllers as their datasheets describe them: bytes and the level of the data/command line in, memory out.

use std::collections::BTreeMap;

/// Places of memory that have been written, and what is there.
pub(crate) type Memory = BTreeMap<(i32, i32), u32>;

/// A window of columns and rows, both ends inside, that is filled row by row.
#[derive(Copy, Clone, Debug, Default)]
struct Window {
    x: (i32, i32),
    y: (i32, i32),
    at: (i32, i32),
}

impl Window {
    fn restart(&mut self) {
        self.at = (self.x.0, self.y.0);
    }

    /// The next place.
    fn next(&mut self) -> (i32, i32) {
        let place = self.at;
        self.at.0 += 1;
        if self.at.0 > self.x.1 {
            self.at = (self.x.0, self.at.1 + 1);
        }
        if self.at.1 > self.y.1 {
            self.at.1 = self.y.0;
        }
        place
    }
}

/// Commands with their parameters: bytes with the line low, and those after each with the line high.
fn commands(bytes: &[(bool, u8)]) -> Vec<(u8, Vec<u8>)> {
    let mut all: Vec<(u8, Vec<u8>)> = vec![];
    for &(is_data, byte) in bytes {
        if is_data {
            all.last_mut().expect("data follow a command").1.push(byte);
        } else {
            all.push((byte, vec![]));
        }
    }
    all
}

/// A controller of the MIPI display command set, for pixels of so many bits.
pub(crate) fn mipi(bytes: &[(bool, u8)], bits: usize) -> Memory {
    let (mut memory, mut window) = (Memory::new(), Window::default());
    let number = |data: &[u8], at: usize| i32::from(u16::from_be_bytes([data[at], data[at + 1]]));
    // Those of the last command that pixels still have to come to.
    let mut left = vec![];
    for (command, data) in commands(bytes) {
        match command {
            0x2a => window.x = (number(&data, 0), number(&data, 2)),
            0x2b => window.y = (number(&data, 0), number(&data, 2)),
            0x2c | 0x3c => {
                if command == 0x2c {
                    window.restart();
                    left.clear();
                }
                assert!(window.x.0 <= window.x.1 && window.y.0 <= window.y.1, "a window: {window:?}");
                left.extend(data.iter().flat_map(|byte| (0..8).rev().map(move |bit| byte >> bit & 1)));
                let whole = left.len() / bits * bits;
                for pixel in left[..whole].chunks(bits) {
                    let value = pixel.iter().fold(0, |value, &bit| value << 1 | u32::from(bit));
                    memory.insert(window.next(), value);
                }
                left.drain(..whole);
            }
            _ => {}
        }
    }
    memory
}

/// A controller with pages: all that matters comes with the line low.
pub(crate) fn pages(bytes: &[(bool, u8)]) -> Memory {
    let (mut memory, mut window, mut is_window) = (Memory::new(), Window::default(), false);
    let mut bytes = bytes.iter().copied();
    let number = |next: Option<(bool, u8)>| {
        let (is_data, byte) = next.expect("a parameter");
        assert!(!is_data, "parameters are commands");
        i32::from(byte)
    };
    while let Some((is_data, byte)) = bytes.next() {
        if is_data {
            let (x, page) = window.next();
            for bit in 0..8 {
                memory.insert((x, page * 8 + bit), u32::from(byte >> bit & 1));
            }
            continue;
        }
        let low = i32::from(byte & 0x0f);
        match byte {
            0x21 | 0x22 => {
                let ends = (number(bytes.next()), number(bytes.next()));
                *(if byte == 0x21 { &mut window.x } else { &mut window.y }) = ends;
                window.restart();
                is_window = true;
            }
            0xb0..=0xbf => {
                assert!(!is_window, "one way to address");
                (window.y, window.at.1) = ((low, low), low);
                window.x.1 = i32::MAX;
            }
            0x00..=0x0f => window.at.0 = window.at.0 & 0xf0 | low,
            0x10..=0x1f => window.at.0 = window.at.0 & 0x0f | low << 4,
            // Those of one parameter, which set up the display.
            0x20 | 0x81 | 0xa8 | 0xd3 | 0xd5 | 0xd9 | 0xda | 0xdb | 0x8d | 0xad => {
                number(bytes.next());
            }
            _ => {}
        }
    }
    memory
}

/// Sharp's memory LCD: packets, each of which is one transaction.
pub(crate) fn memory_lcd(packets: &[Vec<u8>], width: usize) -> Memory {
    let mut memory = Memory::new();
    for packet in packets {
        let (mode, mut rest) = packet.split_first().expect("a mode");
        if mode & 0x20 != 0 {
            memory.clear();
        }
        if mode & 0x80 == 0 {
            continue;
        }
        let line = 2 + width.div_ceil(8);
        while rest.len() > line {
            let (now, then) = rest.split_at(line);
            let y = i32::from(now[0].reverse_bits()) - 1;
            assert!(y >= 0, "lines count from 1");
            for x in 0..width {
                memory.insert((x as i32, y), u32::from(now[1 + x / 8] >> (7 - x % 8) & 1));
            }
            rest = then;
        }
        assert_eq!(rest.len(), 1, "eight bits of nothing at the end");
    }
    memory
}

/// An e-paper controller such as SSD1680, in data entry mode 3: both of its memories.
pub(crate) fn ssd16xx(bytes: &[(bool, u8)]) -> [Memory; 2] {
    let (mut memories, mut window) = ([Memory::new(), Memory::new()], Window::default());
    let number = |data: &[u8], at: usize| i32::from(u16::from_le_bytes([data[at], data[at + 1]]));
    for (command, data) in commands(bytes) {
        match command {
            0x44 => window.x = (data[0].into(), data[1].into()),
            0x45 => window.y = (number(&data, 0), number(&data, 2)),
            0x4e => window.at.0 = data[0].into(),
            0x4f => window.at.1 = number(&data, 0),
            0x24 | 0x26 => {
                for byte in data {
                    let (x, y) = window.next();
                    for bit in 0..8 {
                        let memory = &mut memories[usize::from(command == 0x26)];
                        memory.insert((x * 8 + bit, y), u32::from(byte >> (7 - bit) & 1));
                    }
                }
            }
            _ => {}
        }
    }
    memories
}
