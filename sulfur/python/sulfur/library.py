"""The shared library: finding it, calling it, and what goes wrong."""
import ctypes
import os
import pathlib
import threading

from . import c

VERSION = "0.1.0"  # of the library that this fits


class Error(Exception):
    """A call that the library refused; `code` is a SulfurResult, such as sulfur.c.OUT_OF_RANGE."""

    def __init__(self, code, text):
        super().__init__(text)
        self.code = code


def _candidates():
    given = os.environ.get("SULFUR_LIBRARY")
    if given:
        return [given]
    # Installed, this is lib/sulfur/python/sulfur/library.py.
    installed = pathlib.Path(__file__).resolve().parents[3] / "libsulfur_c.so.0"
    return [str(installed)] * installed.exists() + ["libsulfur_c.so.0"]


def _load():
    tried = []
    for name in _candidates():
        try:
            library = ctypes.CDLL(name)
        except OSError as error:
            tried.append(str(error))
            continue
        for function, (result, parameters) in c.FUNCTIONS.items():
            entry = getattr(library, function)
            entry.restype, entry.argtypes = result, parameters
        found = library.sulfur_version().decode()
        if found != VERSION:
            raise ImportError(f"{name} is version {found} of sulfur; allowed is {VERSION}")
        return library
    raise ImportError("the library sulfur_c was not found: set SULFUR_LIBRARY to its file; " +
                      "; ".join(tried))


library = _load()
_pending = threading.local()  # .error: what a function of the caller has raised


def guarded(function, otherwise=False):
    """The same for C to call: what it raises waits until the library has returned, and nothing of
    the caller's runs until then; the answer is `otherwise`."""
    def run(*arguments):
        if _pending.error is not None:
            return otherwise
        try:
            return function(*arguments)
        except BaseException as error:  # pylint: disable=broad-except
            _pending.error = error
            return otherwise
    return run


def call(function, *arguments):
    """Calls a function that returns a SulfurResult."""
    _pending.error = None
    code = getattr(library, function)(*arguments)
    if _pending.error is not None:
        error, _pending.error = _pending.error, None
        raise error
    if code != c.OK:
        raise Error(code, library.sulfur_last_error().decode())


def get(kind, function, *arguments):
    """What a function leaves at its last parameter."""
    result = kind()
    call(function, *arguments, ctypes.byref(result))
    return result if isinstance(result, ctypes.Structure) else result.value


def find(kind, function, *arguments):
    """What a function may find, or None."""
    result, found = kind(), ctypes.c_bool()
    call(function, *arguments, ctypes.byref(result), ctypes.byref(found))
    return result if found.value else None


def entries(kind, function, *arguments):
    """All entries of a list."""
    count = ctypes.c_size_t()
    call(function, *arguments, None, 0, ctypes.byref(count))
    found = (kind * count.value)()
    call(function, *arguments, found, count.value, ctypes.byref(count))
    return list(found)
