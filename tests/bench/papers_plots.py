"""The pictures of the papers' experiments. Needs numpy and matplotlib (Debian: python3-matplotlib)."""
import os
import sys

import measure

sys.path.insert(0, os.path.join(measure.ROOT, 'scripts'))
import render

images = os.path.join(measure.ROOT, 'build', 'papers', 'images')  # where pictures go
WIDTH = 640  # pixels of one panel, before it is halved


def axes_of(name, draw, size=(7, 3), panels=2):
    """Writes a picture of several panels side by side, which `draw` fills."""
    import matplotlib
    matplotlib.use('Agg')
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(1, panels, figsize=size)
    draw(axes)
    figure.tight_layout()
    os.makedirs(images, exist_ok=True)
    figure.savefig(os.path.join(images, name), dpi=100, metadata={'Software': None})
    plt.close(figure)


def panel(scene, path):
    """A scene, or a fill of it, from above."""
    corners, marks = render.read_folder(path)
    box, cells = render.outline(scene, corners)
    image = render.halve(render.picture(corners, marks, box, (round(WIDTH * (box[3] - box[1]) / (box[2] - box[0])), WIDTH)))
    render.draw_grid(image, cells)
    return image / 255


def draw_fills(scene, fills):
    """Draws papers_figure14.png: a scene with its holes and its fills by title."""
    images = {'figure 14: the holes': panel(scene, scene)} | {title: panel(scene, path) for title, path in fills.items()}

    def draw(axes):
        for side, (title, image) in zip(axes, images.items()):
            side.imshow(image.clip(0, 1))
            side.set_title(title, fontsize=9)
            side.axis('off')
    axes_of('papers_figure14.png', draw, (11, 3.1), len(images))
