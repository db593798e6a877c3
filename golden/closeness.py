"""Whether two texts say the same but for what another mathematical library rounds otherwise."""
import platform
import re

# The machine whose output is committed; on its like every byte has to agree.
REFERENCE = ("x86_64", "glibc", "2.36")
ELSEWHERE = 0.02

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w])")


def default_tolerance():
    machine = (platform.machine(), *platform.libc_ver())
    return 0.0 if machine == REFERENCE else ELSEWHERE


def last_place(text):
    """One unit of the last digit that is printed, of a number without exponent."""
    return 10.0 ** -len(text.partition(".")[2])


def numbers_agree(a, b, tolerance):
    """Whole numbers count things, and have to be equal. Of a number with an exponent, often a probability, the logarithm
    is compared; other numbers may differ in their last place in any case."""
    if a == b:
        return True
    if "e" in (a + b).lower():
        mantissas = [re.split("[eE]", text) for text in (a, b)]
        decades = [float(parts[1]) if len(parts) == 2 else 0.0 for parts in mantissas]
        return abs(decades[0] - decades[1]) <= 1 + tolerance * max(map(abs, decades))
    if "." not in a or "." not in b:
        return False
    x, y = float(a), float(b)
    slack = max(tolerance * max(abs(x), abs(y)), 1.5 * max(last_place(a), last_place(b)))
    return abs(x - y) <= slack


def texts_agree(a, b, tolerance):
    if a == b or tolerance == 0:
        return a == b
    if NUMBER.split(a) != NUMBER.split(b):
        return False
    return all(numbers_agree(x, y, tolerance) for x, y in zip(NUMBER.findall(a), NUMBER.findall(b)))


def names_of(listing):
    """File names of "SHA256  NAME" lines."""
    return [line.split("  ", 1)[1] for line in listing.splitlines()]


def agree(key, expected, actual, tolerance):
    """Bytes of files follow the last bit of every coordinate, so elsewhere only their names count."""
    if key == "expected.files" and tolerance > 0:
        return names_of(expected) == names_of(actual)
    if key == "expected.status":
        return expected == actual
    return texts_agree(expected, actual, tolerance)
