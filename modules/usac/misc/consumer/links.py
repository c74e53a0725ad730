#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Finds links to files or anchors that do not exist in the HTML pages of a folder.
usage: links.py FOLDER"""

import os
import re
import sys
from html import unescape
from urllib.parse import unquote


def main(folder):
    places, links = {}, []
    for page in sorted(name for name in os.listdir(folder) if name.endswith(".html")):
        with open(os.path.join(folder, page), encoding="utf-8") as file:
            text = file.read()
        places[page] = set(re.findall(r'(?:id|name)="([^"]+)"', text))
        links += [(page, unescape(link)) for link in re.findall(r'(?:href|src)="([^"]+)"', text)]
    bad = set()
    for page, link in links:
        # In a short index, doxygen 1.17 makes links to letters without making their anchors.
        if re.match(r"(https?|mailto|javascript):|#index_\w+$", link):
            continue
        target, _, place = link.partition("#")
        target = unquote(target) or page
        if not os.path.exists(os.path.join(folder, target)) or (place and target in places and place not in places[target]):
            bad.add((page, link))
    for page, link in sorted(bad):
        print(f"{page}: {link}")
    print(f"{len(places)} pages, {len(links)} links, {len(bad)} lead nowhere")
    return 1 if bad or not links else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
