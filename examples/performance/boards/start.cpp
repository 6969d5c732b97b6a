// Runs `draw` on a Cortex-M4F in QEMU and says how many instructions it took. The clock is that of the Rust programs.
#include <stdint.h>

void draw(void (*put)(int, int, int));
int main();

extern "C" {
extern uint32_t stack_start, data_start, data_end, data_image, bss_start, bss_end;

void reset() {
    *(volatile uint32_t *)0xE000ED88 = 0xF << 20; // The FPU may be used.
    const uint32_t *image = &data_image;
    for (uint32_t *word = &data_start; word < &data_end; word++) *word = *image++;
    for (uint32_t *word = &bss_start; word < &bss_end; word++) *word = 0;
    main();
}

static volatile uint32_t wraps;
static void wrap() { wraps = wraps + 1; }
}

// Semihosting.
static int call(int operation, const void *argument) {
    register int r0 asm("r0") = operation;
    register const void *r1 asm("r1") = argument;
    asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void print(const char *text, uint32_t length) {
    const uint32_t console[3] = {(uint32_t)":tt", 4, 3};
    const uint32_t written[3] = {(uint32_t)call(1, console), (uint32_t)text, length};
    call(5, written);
}

template <uint32_t SIZE_WITH_NUL> static void print(const char (&text)[SIZE_WITH_NUL]) { print(text, SIZE_WITH_NUL - 1); }

static void exit_with(int code) {
    const uint32_t reason[2] = {0x20026, (uint32_t)code};
    call(0x20, reason);
}

static void fault() {
    print("fault of the processor\n");
    exit_with(1);
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    &stack_start, (void *)reset, (void *)fault, (void *)fault, (void *)fault, (void *)fault,
    (void *)fault, 0, 0, 0, 0, (void *)fault, (void *)fault, 0, (void *)fault, (void *)wrap,
};

// SysTick, whose 25 MHz are 40 of the emulator's nanoseconds, in each of which it takes an instruction.
static volatile uint32_t *const timer = (volatile uint32_t *)0xE000E010;
static const uint32_t longest = 0xFFFFFF;

static uint64_t instructions() {
    for (;;) {
        uint32_t before = wraps, left = timer[2];
        if (wraps == before) return ((uint64_t)before * (longest + 1) + (longest - left)) * 40;
    }
}

static void print_number(uint64_t number, unsigned base) {
    char text[20], *digit = text + sizeof text;
    do {
        *--digit = "0123456789abcdef"[number % base];
        number /= base;
    } while (number > 0);
    print(digit, text + sizeof text - digit);
}

static uint8_t picture[3 * SIZE * SIZE], *next = picture;

static void put(int red, int green, int blue) {
    *next++ = red;
    *next++ = green;
    *next++ = blue;
}

#ifdef COUNTED
extern unsigned rays;
#endif

int main() {
    timer[1] = longest;
    timer[2] = 0;
    timer[0] = 7;
    while (timer[2] == 0) {} // It begins with the next tick.
    uint64_t start = instructions();
    draw(put);
    uint64_t taken = instructions() - start;

    uint64_t checksum = 0xCBF29CE484222325;
    for (uint8_t byte : picture) checksum = (checksum ^ byte) * 0x100000001B3;
    print("checksum ");
    print_number(checksum, 16);
    print("\npixels: ");
    print_number(SIZE * SIZE, 10);
    print("\ninstructions: ");
    print_number(taken, 10);
#ifdef COUNTED
    print("\nrays: ");
    print_number(rays, 10);
#endif
    print("\n");
    exit_with(0);
}
