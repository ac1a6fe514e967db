// SPDX-License-Identifier: MIT
// Hashed gradient noise in the plane, and sums of its octaves.

uint hashCell(ivec2 cell)
{
    uint h = uint(cell.x) * 0x8da6b343u + uint(cell.y) * 0xd8163841u;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return h;
}

vec2 cellGradient(ivec2 cell)
{
    float angle = float(hashCell(cell) & 0xffffu) * (6.28318531 / 65536.0);
    return vec2(cos(angle), sin(angle));
}

// Within about [-0.7, 0.7], mean 0.
float gradientNoise(vec2 p)
{
    vec2 cellF = floor(p);
    ivec2 cell = ivec2(cellF);
    vec2 f = p - cellF;
    vec2 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float a = dot(cellGradient(cell), f);
    float b = dot(cellGradient(cell + ivec2(1, 0)), f - vec2(1.0, 0.0));
    float c = dot(cellGradient(cell + ivec2(0, 1)), f - vec2(0.0, 1.0));
    float d = dot(cellGradient(cell + ivec2(1, 1)), f - vec2(1.0, 1.0));
    return mix(mix(a, b, u.x), mix(c, d, u.x), u.y);
}

// Octaves turned against each other so that no lattice shows. `smallest` is the wavelength below which octaves fade
// out.
float fractalNoise(vec2 p, int octaves, float smallest)
{
    float sum = 0.0;
    float amplitude = 0.5;
    float wavelength = 1.0;
    for (int i = 0; i < octaves; ++i)
    {
        float seen = clamp(wavelength / smallest - 1.0, 0.0, 1.0);
        if (seen <= 0.0)
        {
            break;
        }
        sum += amplitude * seen * gradientNoise(p);
        p = mat2(1.6, 1.2, -1.2, 1.6) * p + vec2(17.3, -9.1);
        amplitude *= 0.5;
        wavelength *= 0.5;
    }
    return sum;
}

// The same noise and its slopes along x and z: value, d/dx, d/dy.
vec3 gradientNoiseSlopes(vec2 p)
{
    vec2 cellF = floor(p);
    ivec2 cell = ivec2(cellF);
    vec2 f = p - cellF;
    vec2 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec2 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    vec2 ga = cellGradient(cell), gb = cellGradient(cell + ivec2(1, 0));
    vec2 gc = cellGradient(cell + ivec2(0, 1)), gd = cellGradient(cell + ivec2(1, 1));
    float a = dot(ga, f), b = dot(gb, f - vec2(1.0, 0.0));
    float c = dot(gc, f - vec2(0.0, 1.0)), d = dot(gd, f - vec2(1.0, 1.0));
    vec2 slopes = mix(mix(ga, gb, u.x), mix(gc, gd, u.x), u.y);
    slopes += du * vec2(mix(b - a, d - c, u.y), mix(c - a, d - b, u.x));
    return vec3(mix(mix(a, b, u.x), mix(c, d, u.x), u.y), slopes);
}

// fractalNoise() and its slopes.
vec3 fractalNoiseSlopes(vec2 p, int octaves, float smallest)
{
    vec3 sum = vec3(0.0);
    float amplitude = 0.5;
    float wavelength = 1.0;
    mat2 turned = mat2(1.0); // how p changes with the place
    for (int i = 0; i < octaves; ++i)
    {
        float seen = clamp(wavelength / smallest - 1.0, 0.0, 1.0);
        if (seen <= 0.0)
        {
            break;
        }
        vec3 noise = gradientNoiseSlopes(p);
        sum += amplitude * seen * vec3(noise.x, noise.yz * turned);
        const mat2 turn = mat2(1.6, 1.2, -1.2, 1.6);
        p = turn * p + vec2(17.3, -9.1);
        turned = turn * turned;
        amplitude *= 0.5;
        wavelength *= 0.5;
    }
    return sum;
}
