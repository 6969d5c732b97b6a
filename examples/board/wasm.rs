//! WebAssembly: text goes to a function of the engine.

use core::panic::PanicInfo;

mod host {
    #[link(wasm_import_module = "board")]
    unsafe extern "C" {
        pub fn write(text: *const u8, length: usize);
    }
}

/// Prints bytes of text for the user.
pub fn write(text: &[u8]) {
    // SAFETY: the function reads these bytes of the program's memory and keeps nothing.
    unsafe { host::write(text.as_ptr(), text.len()) }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
