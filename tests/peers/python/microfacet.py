"""Grazing's microfacet models beside Mitsuba's.

`microfacet.py evaluate GRAZING MODEL` prints f_r of Grazing as a table.
`microfacet.py compare TABLE WAY DISTRIBUTION ROUGHNESS ETA` fails where Mitsuba disagrees with it. WAY is `parts`, for D, G and
F, or `plugin`, for the whole of roughdielectric; the last two are factors, 1 unless an error is planted.
"""

import csv
import json
import math
import random
import subprocess
import sys
from itertools import islice, product

ROUGHNESS = [0.02, 0.05, 0.1, 0.3, 0.6, 1.0]
ETA = [1.05, 1.5, 2.0, 3.0]
# Pairs of directions for each roughness and η.
PAIRS = 500
ENOUGH = 5000
LARGEST_ANGLE = 89.0
# Relative. Mitsuba's packages have no variant in f64; its half vector in f32 moves the narrowest lobe by 6e-5 near the horizon.
TOLERANCE = 1e-4
# Mitsuba takes D cos θh for 0 from here on.
SMALLEST = 1e-20
ANGLES = ["theta_i", "phi_i", "theta_o", "phi_o"]


def vector(theta, phi):
    theta, phi = math.radians(theta), math.radians(phi)
    return math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def half_vector(wi, wo):
    total = [x + y for x, y in zip(wi, wo)]
    length = math.sqrt(dot(total, total))
    return tuple(x / length for x in total)


def pairs(roughness, rng):
    """Angles in degrees: half of the pairs anywhere, half where the lobe is high."""
    while True:
        theta_i, phi_i = rng.uniform(0, LARGEST_ANGLE), rng.uniform(-180, 180)
        yield theta_i, phi_i, rng.uniform(0, LARGEST_ANGLE), rng.uniform(-180, 180)
        wi = vector(theta_i, phi_i)
        theta_o = math.inf
        while theta_o > LARGEST_ANGLE:
            slope = roughness * rng.uniform(0, 3)
            wh = vector(math.degrees(math.atan(slope)), rng.uniform(-180, 180))
            x, y, z = (2 * dot(wi, wh) * h - i for i, h in zip(wi, wh))
            theta_o = math.degrees(math.atan2(math.hypot(x, y), z))
        yield theta_i, phi_i, theta_o, math.degrees(math.atan2(y, x))


def evaluate(grazing, model):
    rng = random.Random(1)
    table = csv.writer(sys.stdout)
    table.writerow([*ANGLES, "roughness", "eta", "r", "g", "b"])
    for roughness, eta in product(ROUGHNESS, ETA):
        brdf = {"model": model, "fresnel": "exact", "rho_d": [0, 0, 0], "k_s": [1, 1, 1], "roughness": roughness, "eta": eta}
        with open("model.json", "w") as file:
            json.dump(brdf, file)
        with open("directions.csv", "w", newline="") as file:
            directions = csv.writer(file)
            directions.writerow(ANGLES)
            directions.writerows(islice(pairs(roughness, rng), PAIRS))
        command = [grazing, "eval", "model.json", "--directions", "directions.csv"]
        answer = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
        for row in csv.DictReader(answer.splitlines()):
            table.writerow([*(row[angle] for angle in ANGLES), roughness, eta, row["r"], row["g"], row["b"]])


def compare(path, way, distribution, roughness_factor, eta_factor):
    import mitsuba as mi

    mi.set_variant("scalar_rgb")

    def parts(roughness, eta):
        kinds = {"ggx": mi.MicrofacetType.GGX, "beckmann": mi.MicrofacetType.Beckmann}
        microfacets = mi.MicrofacetDistribution(kinds[distribution], roughness)

        def f_r(wi, wo, wh):
            fresnel = mi.fresnel(dot(wi, wh), eta)[0]
            return [microfacets.eval(wh) * microfacets.G(wi, wo, wh) * fresnel / (4 * wi[2] * wo[2])] * 3

        return f_r

    def plugin(roughness, eta):
        material = {"type": "roughdielectric", "distribution": distribution, "alpha": roughness, "int_ior": eta, "ext_ior": 1.0}
        bsdf, context, hit = mi.load_dict(material), mi.BSDFContext(), mi.SurfaceInteraction3f()

        def f_r(wi, wo, _):
            hit.wi = wi
            return [value / wo[2] for value in bsdf.eval(context, hit, wo)]

        return f_r

    # The rows of a material are one after the other.
    material, f_r = None, None
    compared, worst, where = 0, 0.0, ""
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            roughness, eta = float(row["roughness"]), float(row["eta"])
            if material != (roughness, eta):
                material = roughness, eta
                f_r = {"parts": parts, "plugin": plugin}[way](roughness * roughness_factor, eta * eta_factor)
            theta_i, phi_i, theta_o, phi_o = (float(row[angle]) for angle in ANGLES)
            wi, wo = vector(theta_i, phi_i), vector(theta_o, phi_o)
            wh = half_vector(wi, wo)
            smallest = SMALLEST / (4 * wi[2] * wo[2] * wh[2])
            for channel, theirs in zip("rgb", f_r(wi, wo, wh)):
                ours = float(row[channel])
                if abs(ours) <= smallest and theirs <= smallest:
                    continue
                compared += channel == "r"
                off = (abs(ours - theirs) - smallest) / theirs if theirs > 0 and math.isfinite(ours) else math.inf
                if off > worst:
                    worst, where = off, f"{row}: Mitsuba has {theirs}"
    print(f"{path}, {way}: {compared} pairs, at most {worst:.1e} apart")
    if worst > TOLERANCE:
        sys.exit(f"Mitsuba disagrees: {where}")
    # So many that agreement about nothing is none.
    if compared < ENOUGH:
        sys.exit(f"only {compared} pairs have a value")


if __name__ == "__main__":
    if sys.argv[1] == "evaluate":
        evaluate(*sys.argv[2:])
    else:
        compare(*sys.argv[2:5], *map(float, sys.argv[5:]))
