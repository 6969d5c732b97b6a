//! What the programs have in common that render a scene on bare metal: how they start, and how they find out how much
//! stack was used.
//!
//! It is compiled by itself for those targets, and not a part of the tool.

use core::arch::asm;
use core::panic::PanicInfo;

unsafe extern "C" {
    // The bounds of the stack's memory (firmware.x).
    static mut stack_end: u32;
    static stack_begin: u32;
}

unsafe extern "Rust" {
    // The scene's.
    safe fn render() -> Option<usize>;
}

/// What the processor looks up when it starts.
#[repr(C)]
struct Vectors {
    stack: *const u32,
    reset: unsafe extern "C" fn() -> !,
}

unsafe impl Sync for Vectors {}

#[used]
#[unsafe(link_section = ".vectors")]
static VECTORS: Vectors = Vectors { stack: &raw const stack_begin, reset };

#[unsafe(no_mangle)]
unsafe extern "C" fn reset() -> ! {
    #[cfg(target_abi = "eabihf")]
    unsafe {
        // Full access to the FPU: coprocessors 10 and 11 in CPACR.
        asm!("str {}, [{}]", "dsb", "isb", in(reg) 0xF_u32 << 20, in(reg) 0xE000_ED88_u32);
    }
    match render() {
        Some(bytes) => {
            write(bytes);
            exit(0x20026) // ADP_Stopped_ApplicationExit
        }
        None => exit(0x20023), // ADP_Stopped_RunTimeErrorUnknown
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    exit(0x20023)
}

const PAINT: u32 = 0xA5C3_5A3C;

/// Fills all memory below the stack pointer, which it gives, with a pattern.
#[inline(always)]
pub fn paint() -> usize {
    let pointer: usize;
    unsafe { asm!("mov {}, sp", out(reg) pointer) };
    let mut place = &raw mut stack_end;
    while (place as usize) < pointer {
        unsafe {
            place.write_volatile(PAINT);
            place = place.add(1);
        }
    }
    pointer
}

/// How many bytes below that stack pointer were written to since.
#[inline(always)]
pub fn used(pointer: usize) -> usize {
    let mut place = &raw const stack_end;
    while (place as usize) < pointer && unsafe { place.read_volatile() } == PAINT {
        place = unsafe { place.add(1) };
    }
    pointer - place as usize
}

/// Writes a number to the debugger (semihosting, SYS_WRITE0).
fn write(number: usize) {
    let mut text = *b"          \n\0";
    let mut rest = number;
    for digit in text.iter_mut().rev().skip(2) {
        *digit = b'0' + (rest % 10) as u8;
        rest /= 10;
    }
    semihosting(0x04, text.as_ptr() as usize);
}

fn exit(reason: usize) -> ! {
    loop {
        semihosting(0x18, reason); // SYS_EXIT
    }
}

fn semihosting(operation: usize, argument: usize) {
    unsafe { asm!("bkpt #0xAB", inout("r0") operation => _, in("r1") argument) };
}

/// A program that renders a scene, 16 by 12 pixels. `step` in it is [`whit::Frame::step`] of that scene.
macro_rules! firmware {
    (
        number: $number:ty, effects: $effects:expr, depth: $depth:expr, media: $media:expr, tracer: $tracer:expr,
        bounces: $bounces:expr
    ) => {
        use core::mem::MaybeUninit;
        use whit::render::{LinearRgb, Progress, Size};
        use whit::{Frame, Rgb, Settings};

        const SIZE: Size = Size::new(16, 12);
        type Drawn = Frame<'static, $number, { $effects.bits() }, { $depth }, (), { $media }>;

        static mut PIXELS: [Rgb<f32>; SIZE.pixels() as usize] = [Rgb::BLACK; SIZE.pixels() as usize];
        #[unsafe(no_mangle)]
        static mut FRAME: MaybeUninit<Drawn> = MaybeUninit::uninit();

        #[unsafe(no_mangle)]
        #[inline(never)]
        fn step(frame: &mut Drawn, rays: u32, target: &mut LinearRgb<'static>) -> bool {
            matches!(frame.step(rays, target), Ok(Progress::More))
        }

        /// The bytes of stack that `step` used.
        #[unsafe(no_mangle)]
        fn render() -> Option<usize> {
            let pixels = unsafe { &mut *(&raw mut PIXELS) };
            let frame = unsafe { &mut *(&raw mut FRAME) };
            let mut target = LinearRgb::new(SIZE, pixels).ok()?;
            let settings = Settings::new(SIZE.width, SIZE.height).with_depth($bounces);
            let frame = frame.write(Frame::new(&$tracer, settings).ok()?);
            let pointer = firmware::paint();
            while step(frame, 100, &mut target) {}
            let bytes = firmware::used(pointer);
            let light = unsafe { &*(&raw const PIXELS) }.iter().any(|pixel| pixel.luminance() > 0.0);
            light.then_some(bytes)
        }
    };
}
