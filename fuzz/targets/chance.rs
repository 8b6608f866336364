//! A search that can be made again.

/// Where chance comes from, which orders what a hash table holds: always the same, so that a search can be made again.
///
/// # Safety
///
/// That of the system's own function: there is room for so many bytes.
#[unsafe(no_mangle)]
unsafe extern "C" fn getrandom(room: *mut u8, length: usize, _flags: u32) -> isize {
    // SAFETY: as above.
    unsafe { room.write_bytes(7, length) };
    length.cast_signed()
}
