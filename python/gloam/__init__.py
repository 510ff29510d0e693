# SPDX-License-Identifier: MIT
"""GLSL functions as Python functions of numpy arrays, run on a Vulkan driver and judged.

    tone = gloam.File("tone.glsl")["tone_reinhard"]
    tone(0.5)                                       one value
    tone(numpy.linspace(0, 1, 1000))                many in one dispatch
    print(tone.compare(lambda x: x / (1 + x), {"x": (0, 1000)}, ulp=4))
    print(tone.check_rules())                       by what Vulkan permits: no reference
    print(tone.audit())                             where the function itself goes wrong
    print(tone.explain(0.5))                        one input, operation by operation

Arrays are those of the GLSL type behind any leading dimensions, which broadcast: vec3 (..., 3), mat4x3 (..., 4, 3) with
a row for each column of the matrix, float[2][3] (..., 2, 3), a structure (..., number of its scalars) as uint32 words.
Functions with derivatives take an array of a quad's four values, functions of a work group one of all its invocations.
"""
import numpy as np

from . import _gloam

__all__ = ["Answer", "File", "Function"]

__version__ = _gloam.__version__
Answer = _gloam.Answer  # true if it passed; str() tells the rest; passed, inputs, outside, worst_ulp


class File:
    """The functions of a GLSL file on a device. include_roots: folders of what it includes, beside its own. device: as
    in `gloam check --device`, by default the first Vulkan device; "interpreter" needs no driver. variant: how it is
    compiled, as in `gloam check --variant`. defines: macros, "NAME" or "NAME=VALUE". Raises OSError or RuntimeError for
    a file that cannot be read or compiled, and where there is no such device."""

    def __init__(self, path, include_roots=(), device="", variant="", defines=()):
        open(path, "rb").close()  # raises what Python raises for a file that cannot be read
        self._file = _gloam.File(str(path), [str(root) for root in include_roots], device, variant,
                                 list(defines))
        self.device = self._file.device
        self.left_out = self._file.left_out  # functions that cannot be called, each with the reason

    def __iter__(self):
        return iter(self._file.names)

    def __getitem__(self, name):
        """A function; of overloads by its types: "luma(vec3)". Raises ValueError for one that the file lacks, and with
        the reason for one that cannot be called."""
        return Function(self._file.function(name))


class Function:
    """A GLSL function, compiled. Its inputs are its parameters, and the uniforms and stage inputs that it uses."""

    def __init__(self, function):
        self._function = function
        self._inputs = [one for one in function.variables if one.is_input]
        self._outputs = [one for one in function.variables if not one.is_input]

    def __repr__(self):
        return self._function.declaration

    @property
    def inputs(self):
        """Names and GLSL types."""
        return {one.name: one.glsl for one in self._inputs}

    def __call__(self, *values):
        """The result, then each out parameter: one array, or a tuple of several. Raises ValueError for a wrong number
        of values, or shapes that do not fit."""
        words, batch = self._words(values)
        none = np.zeros((0, sum(map(_word_count, self._outputs))), dtype=np.uint32)
        rows = self._function.run(words) if len(words) else none
        outputs = [_values(rows, first, one).reshape(batch + tuple(one.shape))
                   for first, one in _positions(self._outputs)]
        outputs = [one if one.ndim else one[()] for one in outputs]
        return outputs[0] if len(outputs) == 1 else tuple(outputs)

    def compare(self, reference, ranges=None, ulp=0.0, absolute=0.0, inputs=4096, seed=1):
        """Compares with reference(*inputs), which is called for each input with float64 numbers or arrays and returns
        the result in double, or a tuple with each out parameter. A result passes within `ulp` units in the last place
        or within `absolute`. ranges: {"x": (low, high)}; others as domain() tells."""
        def of_words(words):
            row = np.array([words], dtype=np.uint32)
            results = reference(*(_exact(_values(row, first, one)[0]) for first, one in _positions(self._inputs)))
            results = results if isinstance(results, tuple) else (results,)
            return np.concatenate([np.ravel(np.asarray(one, dtype=np.float64)) for one in results]).tolist()
        return self._function.judge(ranges or {}, inputs, seed, ulp, absolute, of_words)

    def check_rules(self, ranges=None, inputs=4096, seed=1):
        """Whether Vulkan's precision rules permit the results."""
        return self._function.judge(ranges or {}, inputs, seed, 0.0, 0.0, None)

    def audit(self, ranges=None, inputs=1024, seed=1):
        """A text: which inputs give NaN or undefined results, lose digits, and so on."""
        return self._function.audit(ranges or {}, inputs, seed)

    def explain(self, *values, lines=16):
        """A text: one input, operation by operation."""
        words, batch = self._words(values)
        if batch:
            raise ValueError(f"{self!r}: expected one input, got {batch}")
        return self._function.explain(words[0].tolist(), lines)

    def domain(self, ranges=None):
        """Which values the inputs have in compare(), check_rules() and audit(), a line each."""
        return self._function.domain(ranges or {})

    def _words(self, values):
        if len(values) != len(self._inputs):
            raise ValueError(f"{self!r}: expected {len(self._inputs)} values ({', '.join(self.inputs)}), "
                             f"got {len(values)}")
        arrays = [_array(value, one) for value, one in zip(values, self._inputs)]
        try:
            batch = np.broadcast_shapes(*(array.shape[:array.ndim - len(one.shape)]
                                          for array, one in zip(arrays, self._inputs)))
        except ValueError as error:
            raise ValueError(f"{self!r}: {error}") from None
        count = int(np.prod(batch))
        rows = [np.ascontiguousarray(np.broadcast_to(array, batch + tuple(one.shape))
                                     .reshape(count, _word_count(one))).view(np.uint32)
                for array, one in zip(arrays, self._inputs)]
        words = np.concatenate(rows, axis=1) if rows else np.zeros((1, 0), dtype=np.uint32)
        return np.ascontiguousarray(words), batch


def _in_words(dtype):
    """The type of numpy whose bits are a scalar's word."""
    return {"words": "uint32", "bool": "uint32", "float16": "float32"}.get(dtype, dtype)


def _array(value, variable):
    """A value or many, as _in_words()."""
    dtype = {"words": "uint32"}.get(variable.dtype, variable.dtype)
    array = np.asarray(value, dtype=dtype)
    own = tuple(variable.shape)
    if array.ndim < len(own) or array.shape[array.ndim - len(own):] != own:
        raise ValueError(f"{variable.name}: expected {variable.glsl}, an array of shape (..., "
                         f"{', '.join(map(str, own))}), got {array.shape}" if own
                         else f"{variable.name}: expected {variable.glsl}")
    return array.astype(_in_words(variable.dtype))


def _positions(variables):
    first = 0
    for one in variables:
        yield first, one
        first += _word_count(one)


def _word_count(variable):
    return int(np.prod(variable.shape, dtype=int))


def _values(rows, first, variable):
    """The values of a variable in rows of words, one after another."""
    words = np.ascontiguousarray(rows[:, first:first + _word_count(variable)])
    values = words.view(_in_words(variable.dtype))
    if variable.dtype != "words":
        values = values.astype(variable.dtype)
    return values.reshape((len(rows),) + tuple(variable.shape))


def _exact(value):
    """As float64, or the integer or bool that it is."""
    value = np.asarray(value)
    value = value.astype(np.float64) if value.dtype in (np.float16, np.float32) else value
    return value if value.ndim else value[()]
