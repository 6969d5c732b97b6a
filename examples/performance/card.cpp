// Renders the scene of Andrew Kensler's ray tracer on a business card, by the same operations in the same order: it writes the
// same bytes, where `rand` is the same.
//
//     g++ -O2 card.cpp -o card && ./card > card.ppm
//
// Macros:
//   SIZE      pixels a side; each covers 512/SIZE of the original's
//   SAMPLES   a pixel
//   SINGLE    no double precision; with -fsingle-precision-constant
//   COUNTED   counts the rays
//   BOARD     no main program: another file calls `draw`
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef SIZE
#define SIZE 512
#endif
#ifndef SAMPLES
#define SAMPLES 64
#endif

static float root(float x) { return sqrtf(x); }

#ifdef SINGLE
static float power(float base, float exponent) { return powf(base, exponent); }
#else
static double power(float base, int exponent) { return pow(base, exponent); }
#endif

#ifdef COUNTED
unsigned rays = 0;
#endif

struct Vector {
    float x, y, z;

    Vector operator+(Vector other) const { return {x + other.x, y + other.y, z + other.z}; }
    Vector operator*(float factor) const { return {x * factor, y * factor, z * factor}; }
};

static float dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static Vector cross(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static Vector normalize(Vector a) { return a * (1 / root(dot(a, a))); }

// From 0 to 1.
static float uniform() { return (float)rand() / RAND_MAX; }

enum Hit { SKY, FLOOR, SPHERE };

// The letters from the bottom up: where bit k is set there is a sphere at x = k.
static const int rows = 9, columns = 19;
static const int letters[rows] = {247570, 280596, 280600, 249748, 18578, 18577, 231184, 16, 16};

// What a ray meets first, how far away, and the normal there.
static Hit trace(Vector origin, Vector direction, float &distance, Vector &normal) {
#ifdef COUNTED
    rays++;
#endif
    distance = 1e9;
    Hit hit = SKY;
    float floor_distance = -origin.z / direction.z;
    if (.01 < floor_distance) {
        distance = floor_distance;
        normal = {0, 0, 1};
        hit = FLOOR;
    }
    for (int column = columns; column--;) {
        for (int row = rows; row--;) {
            if (!(letters[row] & 1 << column)) continue;
            Vector from_center = origin + Vector{(float)-column, 0, (float)(-row - 4)};
            float b = dot(from_center, direction);
            float c = dot(from_center, from_center) - 1;
            float discriminant = b * b - c;
            if (discriminant > 0) {
                float near = -b - root(discriminant);
                if (near < distance && near > .01) {
                    distance = near;
                    normal = normalize(from_center + direction * distance);
                    hit = SPHERE;
                }
            }
        }
    }
    return hit;
}

// The light that comes back along a ray.
static Vector light(Vector origin, Vector direction) {
    float distance;
    Vector normal;
    Hit hit = trace(origin, direction, distance, normal);
    if (hit == SKY) return Vector{.7, .6, 1} * power(1 - direction.z, 4);

    Vector point = origin + direction * distance;
    // A point of the lamp, a square; its coordinates take random numbers from the last to the first.
    float lamp_y = 9 + uniform();
    float lamp_x = 9 + uniform();
    Vector to_lamp = normalize(Vector{lamp_x, lamp_y, 16} + point * -1);
    Vector mirrored = direction + normal * (dot(normal, direction) * -2);
    float cosine = dot(to_lamp, normal);
    if (cosine < 0 || trace(point, to_lamp, distance, normal) != SKY) cosine = 0;
    float highlight = power(dot(to_lamp, mirrored) * (cosine > 0), 99);

    if (hit == FLOOR) {
        point = point * .2;
        bool is_odd = (int)(ceil(point.x) + ceil(point.y)) & 1;
        return (is_odd ? Vector{3, 1, 1} : Vector{3, 3, 3}) * (cosine * .2 + .1);
    }
    return Vector{highlight, highlight, highlight} + light(point, mirrored) * .5;
}

// Hands over each pixel's red, green and blue, row by row.
void draw(void (*put)(int, int, int)) {
    Vector forward = normalize({-6, -16, 0});
    Vector right = normalize(cross({0, 0, 1}, forward)) * .002;
    Vector up = normalize(cross(forward, right)) * .002;
    Vector corner = (right + up) * -256 + forward;
    const int step = 512 / SIZE;
    const float brightness = 3.5 * 64 / SAMPLES;

    for (int y = SIZE; y--;) {
        for (int x = SIZE; x--;) {
            Vector color = {13, 13, 13};
            for (int sample = SAMPLES; sample--;) {
                // A point of the lens, and one of the pixel.
                float lens_v = uniform() - .5, lens_u = uniform() - .5;
                Vector lens = right * lens_u * 99 + up * lens_v * 99;
                float v = (y + uniform()) * step, u = (uniform() + x) * step;
                Vector direction = normalize(lens * -1 + (right * u + up * v + corner) * 16);
                color = light(Vector{17, 16, 8} + lens, direction) * brightness + color;
            }
            put((int)color.x, (int)color.y, (int)color.z);
        }
    }
}

#ifndef BOARD
static void print(int red, int green, int blue) { printf("%c%c%c", red, green, blue); }

int main() {
    printf("P6 %d %d 255 ", SIZE, SIZE);
    draw(print);
}
#endif
