#!/usr/bin/env python3
"""usage: validate.py SCHEMA DECK...

Checks that SCHEMA is valid draft 7 and that each deck is valid by it, read as YAML 1.2 (YAML 1.1 turns `on` and `y` into
booleans). Decks that end in .part.yaml do not stand alone and are passed over. Ends with 3 when a deck is not valid; a
program that breaks ends with 1.
"""
import json
import sys

import jsonschema
from ruamel.yaml import YAML


def plain(value):
    """ruamel's containers as JSON's."""
    if isinstance(value, dict):
        return {str(k): plain(v) for k, v in value.items()}
    if isinstance(value, list):
        return [plain(v) for v in value]
    return value


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    with open(arguments[0], encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    mistakes = 0
    for path in arguments[1:]:
        if path.endswith(".part.yaml"):
            continue
        reader = YAML(typ="safe", pure=True)
        reader.version = (1, 2)
        with open(path, encoding="utf-8") as file:
            deck = plain(reader.load(file))
        for error in validator.iter_errors(deck):
            mistakes += 1
            where = "/".join(str(part) for part in error.absolute_path)
            print(f"{path}: {where}: {error.message[:300]}")
    return 3 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
