//! Sets of characters, as they are asked for: `0x20-0x7e,0xb0,0xe9`.

/// The characters of ranges and single codes, hexadecimal with `0x` and decimal without; what is no character is left out.
///
/// # Errors
/// With what is not a number, or not a range.
pub fn parse(text: &str) -> Result<Vec<char>, String> {
    let number = |text: &str| {
        let hexadecimal = text.strip_prefix("0x").or_else(|| text.strip_prefix("U+"));
        let number = hexadecimal.map_or_else(|| text.parse(), |digits| u32::from_str_radix(digits, 16));
        number.ok().filter(|&n| n <= u32::from(char::MAX)).ok_or_else(|| format!("{text:?} is not a character code"))
    };
    let mut found = vec![];
    for part in text.split(',').map(str::trim) {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        let (first, last) = (number(first)?, number(last)?);
        if first > last {
            return Err(format!("{part:?} ends before it begins"));
        }
        found.extend((first..=last).filter_map(char::from_u32));
    }
    Ok(found)
}

/// The printable characters of ASCII.
pub fn ascii() -> Vec<char> {
    (' '..='~').collect()
}
