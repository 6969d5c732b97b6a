//! The way to the display on the board lm3s6965evb, from the data sheet of its microcontroller, Texas Instruments'
//! LM3S6965: the serial bus SSI0, and two pins.
//!
//! Seen to work in QEMU, which needs no more than this. The board itself also wants the pins of the bus given to it and
//! a clock for it.

use core::convert::Infallible;

use embedded_hal::digital::{ErrorType as PinError, OutputPin};
use embedded_hal::spi::{ErrorType as BusError, Operation, SpiDevice};

const CLOCKS_OF_DEVICES: Register = Register(0x400F_E104); // RCGC1
const CLOCKS_OF_PORTS: Register = Register(0x400F_E108); // RCGC2
const SSI0: u32 = 0x4000_8000;
const SSI_CONTROL_0: Register = Register(SSI0);
const SSI_CONTROL_1: Register = Register(SSI0 + 0x04);
const SSI_DATA: Register = Register(SSI0 + 0x08);
const SSI_STATUS: Register = Register(SSI0 + 0x0C);
const SSI_CLOCK_PRESCALE: Register = Register(SSI0 + 0x10);
const PORT_C: u32 = 0x4000_6000;
const PORT_D: u32 = 0x4000_7000;

/// Of the oscillator with which the microcontroller starts, of 12 MHz, rounded down.
const NANOSECONDS_PER_CYCLE: u32 = 83;

struct Register(u32);

impl Register {
    fn read(&self) -> u32 {
        // SAFETY: the addresses above are those of registers, and reading them has no effect on memory.
        unsafe { (self.0 as *const u32).read_volatile() }
    }

    fn write(&self, value: u32) {
        // SAFETY: as above.
        unsafe { (self.0 as *mut u32).write_volatile(value) }
    }
}

/// A pin as an output.
pub struct Pin {
    /// Bits 2 to 9 of the address say which bits of the data are written.
    data: Register,
    bit: u32,
}

impl Pin {
    fn new(port: u32, number: u32) -> Self {
        let bit = 1 << number;
        for offset in [0x400, 0x51C] {
            let register = Register(port + offset); // Direction; digital function.
            register.write(register.read() | bit);
        }
        Self { data: Register(port + (bit << 2)), bit }
    }
}

impl PinError for Pin {
    type Error = Infallible;
}

impl OutputPin for Pin {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.data.write(0);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.data.write(self.bit);
        Ok(())
    }
}

/// The display's place on the serial bus. A memory card is on it, too, and stays deselected.
pub struct Ssi(());

/// Turns on what the display hangs on: its place on the bus, and the pin that is high for data.
///
/// Called once; two of them would get into each other's way.
pub fn display() -> (Ssi, Pin) {
    CLOCKS_OF_DEVICES.write(CLOCKS_OF_DEVICES.read() | 1 << 4);
    CLOCKS_OF_PORTS.write(CLOCKS_OF_PORTS.read() | 1 << 2 | 1 << 3);
    let Ok(()) = Pin::new(PORT_D, 0).set_high(); // Low would select the card.
    SSI_CONTROL_1.write(0);
    SSI_CLOCK_PRESCALE.write(2);
    SSI_CONTROL_0.write(7); // 8 bits.
    SSI_CONTROL_1.write(1 << 1); // On, as the controller.
    (Ssi(()), Pin::new(PORT_C, 7))
}

impl Ssi {
    fn exchange(&mut self, byte: u8) -> u8 {
        SSI_DATA.write(byte.into());
        while SSI_STATUS.read() & 1 << 2 == 0 {} // Nothing has come in.
        SSI_DATA.read() as u8
    }
}

impl BusError for Ssi {
    type Error = Infallible;
}

impl SpiDevice for Ssi {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        for operation in operations {
            match operation {
                Operation::Write(bytes) => bytes.iter().for_each(|&byte| _ = self.exchange(byte)),
                Operation::Read(bytes) => bytes.fill_with(|| self.exchange(0)),
                Operation::TransferInPlace(bytes) => bytes.iter_mut().for_each(|byte| *byte = self.exchange(*byte)),
                Operation::Transfer(into, from) => {
                    for place in 0..into.len().max(from.len()) {
                        let answer = self.exchange(from.get(place).copied().unwrap_or_default());
                        into.get_mut(place).into_iter().for_each(|byte| *byte = answer);
                    }
                }
                Operation::DelayNs(time) => cortex_m::asm::delay(*time / NANOSECONDS_PER_CYCLE + 1),
            }
        }
        Ok(())
    }
}
