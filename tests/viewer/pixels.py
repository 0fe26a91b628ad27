"""What is seen in pictures: rows of (red, green, blue)."""


def share(picture, is_colour):
    pixels = [pixel for row in picture for pixel in row]
    return sum(map(is_colour, pixels)) / len(pixels)


def differing(one, other):
    """The share of pixels of the scene that differ, and by how much they do at most; beside it are lists and buttons."""
    pairs = [pair for row, line in zip(one[30:], other[30:]) for pair in zip(row[165:], line[165:])]
    differences = [max(abs(x - y) for x, y in zip(p, q)) for p, q in pairs if p != q]
    return sum(difference > 4 for difference in differences) / len(pairs), max(differences, default=0)


def is_blue(pixel):
    red, green, blue = pixel
    return blue > 110 and blue > red + 50 and blue > green + 20


def is_orange(pixel):
    red, green, blue = pixel
    return red > 110 and red > blue + 90 and green > blue + 20
