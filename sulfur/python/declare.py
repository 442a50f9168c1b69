#!/usr/bin/env python3
"""Writes sulfur/c.py, the declarations of the C interface for ctypes, from the headers for C.

    python3 declare.py ../include/sulfur/c > sulfur/c.py
    python3 declare.py ../include/sulfur/c --check sulfur/c.py

The headers keep to a form that these few expressions understand: a struct, a function type, a list
of constants or a function at a time, as C99 has them, one name in each declaration.
"""
import pathlib
import re
import sys

HEADERS = ("base", "blueprint", "shapes", "world", "fields", "presets", "bodies",
           "mechanisms", "parts", "queries", "events", "draw", "callbacks")
SIMPLE = {"void": None, "bool": "c_bool", "double": "c_double", "size_t": "c_size_t",
          "int32_t": "c_int32", "uint32_t": "c_uint32", "uint64_t": "c_uint64"}
OPENING = '''"""The C interface of Sulfur for ctypes: structs, constants, types of functions, functions.

Made by declare.py from sulfur/c/*.h, which say what all of it means. The package makes classes
of it.
"""
from ctypes import (CFUNCTYPE, POINTER, Structure, c_bool, c_char_p, c_double, c_int32, c_size_t,
                    c_uint32, c_uint64, c_void_p)
'''


def python_name(name):
    return re.sub(r"^(Sulfur|SULFUR_)", "", name)


class Types:
    """What is known of C types so far."""

    def __init__(self):
        self.names = dict(SIMPLE)
        self.opaque = set()

    def of(self, text):
        """The ctypes expression of a C type."""
        text = re.sub(r"\bconst\b", "", text).strip()
        base = text.replace("*", "").strip()
        stars = text.count("*")
        if text.replace(" ", "") == "char*":
            return "c_char_p"
        if text.replace(" ", "") == "char**":
            return "POINTER(c_char_p)"
        if base == "void" or base in self.opaque:
            inner, stars = "c_void_p", stars - 1
            if stars < 0:
                return "None"
        else:
            inner = self.names[base]
        for _ in range(stars):
            inner = f"POINTER({inner})"
        return inner

    def of_parameters(self, text):
        """Those of a list of parameters."""
        if text.strip() in ("", "void"):
            return []
        result = []
        for parameter in text.split(","):
            parameter = parameter.strip()
            array = re.search(r"\[\d*\]$", parameter)
            declared = re.sub(r"\w+(\[\d*\])?$", "", parameter)
            result.append(self.of(declared + ("*" if array else "")))
        return result


def without_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)


def members(types, constants, body):
    """The entries of _fields_."""
    result = []
    for member in filter(None, (part.strip() for part in body.split(";"))):
        kind, name, count = re.fullmatch(r"(.*?)(\w+)(?:\[(\w+)\])?", member, re.S).groups()
        entry = types.of(kind)
        if count:
            entry += f" * {constants.get(count, count)}"
        result.append(f'        ("{name}", {entry}),')
    return result


PATTERN = re.compile(
    r"#define (?P<define>SULFUR_\w+) (?P<number>\d+)"
    r"|enum \{(?P<enum>[^}]*)\};"
    r"|typedef struct (?P<struct>\w+) \{(?P<body>[^}]*)\} \w+;"
    r"|typedef struct (?P<opaque>\w+) \w+;"
    r"|typedef (?P<result>[^;()]*?)\(\*(?P<function_type>\w+)\)\((?P<arguments>[^)]*)\);"
    r"|typedef (?P<alias_of>\w+) (?P<alias>\w+);"
    r"|SULFUR_API (?P<returns>[^;()]*?)(?P<function>sulfur_\w+)\((?P<parameters>[^)]*)\);")


def declarations(texts):
    """The lines of sulfur/c.py."""
    types, constants, lines, functions = Types(), {}, [OPENING], []
    for match in PATTERN.finditer(without_comments("\n".join(texts))):
        m = match.groupdict()
        if m["define"]:
            constants[m["define"]] = m["number"]
            lines.append(f'{python_name(m["define"])} = {m["number"]}')
        elif m["enum"]:
            for name, number in re.findall(r"(SULFUR_\w+) = (\d+)", m["enum"]):
                lines.append(f"{python_name(name)} = {number}")
        elif m["struct"]:
            name = types.names[m["struct"]] = python_name(m["struct"])
            lines += ["", "", f"class {name}(Structure):", "    _fields_ = ["]
            lines += members(types, constants, m["body"]) + ["    ]", "", ""]
        elif m["opaque"]:
            types.opaque.add(m["opaque"])
        elif m["function_type"]:
            name = types.names[m["function_type"]] = python_name(m["function_type"])
            parts = [types.of(m["result"])] + types.of_parameters(m["arguments"])
            lines.append(f"{name} = CFUNCTYPE({', '.join(parts)})")
        elif m["alias"]:
            types.names[m["alias"]] = types.names[m["alias_of"]]
        else:
            parameters = types.of_parameters(m["parameters"])
            functions.append(f'    "{m["function"]}": ({types.of(m["returns"])}, '
                             f'[{", ".join(parameters)}]),')
    return lines + ["", "", "FUNCTIONS = {  # name: type of the result, types of the parameters"] \
        + functions + ["}"]


def main():
    folder = pathlib.Path(sys.argv[1])
    known = {folder / f"{name}.h" for name in HEADERS} | {folder / "sulfur.h"}
    if known != set(folder.glob("*.h")):
        sys.exit(f"declare.py: HEADERS are not those of {folder}")
    texts = [(folder / f"{name}.h").read_text(encoding="utf-8") for name in HEADERS]
    text = re.sub(r"\n{3,}", "\n\n\n", "\n".join(declarations(texts))) + "\n"
    declared = set(re.findall(r"\b(sulfur_\w+)\(", without_comments("\n".join(texts))))
    missing = sorted(name for name in declared if f'"{name}"' not in text)
    if missing:
        sys.exit(f"declare.py: not understood: {', '.join(missing)}")
    if "--check" not in sys.argv:
        print(text, end="")
    elif pathlib.Path(sys.argv[-1]).read_text(encoding="utf-8") != text:
        sys.exit(f"{sys.argv[-1]} is not what declare.py makes of the headers; make it anew")


if __name__ == "__main__":
    main()
