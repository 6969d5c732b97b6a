//! Static memory of a module that does one thing at a time.
#![allow(unsafe_code)] // There is no safe way to memory that is known when the module is compiled.

use core::cell::UnsafeCell;

/// A static that only one thread uses.
pub struct Alone<T>(UnsafeCell<T>);

// A module of the page has no threads.
unsafe impl<T> Sync for Alone<T> {}

impl<T> Alone<T> {
    pub const fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// # Safety
    /// Nothing else may refer to the value as long as this is used.
    #[allow(clippy::mut_from_ref)]
    pub unsafe fn get(&self) -> &mut T {
        unsafe { &mut *self.0.get() }
    }
}
