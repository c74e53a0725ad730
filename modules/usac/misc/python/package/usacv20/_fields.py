# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The fields of Params and Report as descriptors, which have a help text and check the types of
assigned values.

Values other than lists of numbers are stored in an object of the compiled part, `_native`. The
compiled part also checks the ranges of numbers: an error is raised when the estimator is created, or
by Params.check()."""

from __future__ import annotations

import enum
import os
import typing
from typing import TYPE_CHECKING, Any, List, Optional, Tuple, Type, Union, overload

import numpy as np

from . import _arguments

if TYPE_CHECKING:
    import numpy.typing as npt

Read = typing.TypeVar("Read")
Enumeration = typing.TypeVar("Enumeration", bound=enum.IntEnum)
Flags = typing.TypeVar("Flags", bound=enum.IntFlag)
Self = typing.TypeVar("Self")


class Field(typing.Generic[Read]):
    """A descriptor of a read-only field."""

    def __init__(self, about: str) -> None:
        self.__doc__ = about
        self.name = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    @overload
    def __get__(self: Self, instance: None, owner: type) -> Self: ...
    @overload
    def __get__(self, instance: object, owner: type) -> Read: ...

    def __get__(self, instance: Any, owner: type) -> Any:
        return self if instance is None else self.read(instance)

    def read(self, instance: Any) -> Any:
        return getattr(instance._native, self.name)

    def __set__(self, instance: Any, value: Any) -> None:
        raise AttributeError("{}: it cannot be written".format(self.name))

    def __delete__(self, instance: Any) -> None:
        raise AttributeError("{}: it cannot be deleted".format(self.name))


class EnumField(Field[Enumeration]):
    """A descriptor of a read-only field whose value is an enumerator."""

    def __init__(self, type_: Type[Enumeration], about: str) -> None:
        super().__init__(about)
        self.type = type_

    def read(self, instance: Any) -> Any:
        return self.type(getattr(instance._native, self.name))


class Real(Field[float]):
    """A descriptor of a field whose value is a number."""

    def __set__(self, instance: Any, value: float) -> None:
        if not _arguments.isReal(value):
            raise TypeError("{}: a number is expected, not {}".format(self.name, _arguments.shown(value)))
        setattr(instance._native, self.name, _arguments.real(value, self.name))


class Integer(Field[int]):
    """A descriptor of a field whose value is an integer."""

    def __set__(self, instance: Any, value: int) -> None:
        if not _arguments.isInteger(value):
            raise TypeError("{}: an integer is expected, not {}".format(self.name, _arguments.shown(value)))
        setattr(instance._native, self.name, _arguments.integer(value, self.name))


def _short(name: str) -> str:
    """Returns a name in the form in which names are compared: "p-napsac" becomes P_NAPSAC,
    "magsac++" becomes MAGSAC_PLUS_PLUS."""
    return name.strip().upper().replace("-", "_").replace(" ", "_").replace("+", "_PLUS")


class Named(Integer):
    """A descriptor of a field whose value is an enumerator or a set of flags. Enumerators can also
    be assigned by name, with or without the prefix that all names of the enumeration share."""

    def __init__(self, type_: Union[Type[enum.IntEnum], Type[enum.IntFlag]], about: str) -> None:
        super().__init__(about)
        self.enumeration = type_
        self.names = list(type_.__members__)
        prefix = os.path.commonprefix(self.names).rpartition("_")[0] + "_"
        self.named = {name: int(type_[name].value) for name in self.names}
        self.named.update({name[len(prefix):]: number for name, number in list(self.named.items())})

    def refused(self, value: Any) -> TypeError:
        return TypeError("{}: a {} is expected, {}, or a short name such as '{}', not {}".format(
            self.name, self.enumeration.__name__, ", ".join(self.names),
            min((name for name in self.named if name not in self.names), key=len).lower(), _arguments.shown(value)))

    def __set__(self, instance: Any, value: Union[int, str]) -> None:
        if isinstance(value, str):
            number = 0
            for name in self.split(value):
                if _short(name) not in self.named:
                    raise self.refused(value)
                number |= self.named[_short(name)]
            value = number
        elif not _arguments.isInteger(value) or _arguments.isOfAnother(value, self.enumeration):
            raise self.refused(value)
        super().__set__(instance, value)

    def split(self, names: str) -> List[str]:
        return [names]


class Option(Named, typing.Generic[Enumeration]):
    """A descriptor of a field whose value is one enumerator. Any other integer is stored unchanged,
    and Params.check() then raises usacv20.error."""

    def __init__(self, type_: Type[Enumeration], about: str) -> None:
        super().__init__(type_, about)
        self.type = type_
        self.values = {int(value): value for value in type_}

    if TYPE_CHECKING:
        @overload
        def __get__(self: Self, instance: None, owner: type) -> Self: ...
        @overload
        def __get__(self, instance: object, owner: type) -> Enumeration: ...
        def __get__(self, instance: Any, owner: type) -> Any: ...

    def read(self, instance: Any) -> Any:
        value = getattr(instance._native, self.name)
        return self.values.get(value, value)


class Set(Named, typing.Generic[Flags]):
    """A descriptor of a field whose value is a set of flags, which can also be assigned by names,
    "a|b". An integer with other bits is stored unchanged, and Params.check() then raises
    usacv20.error."""

    def __init__(self, type_: Type[Flags], about: str) -> None:
        super().__init__(type_, about)
        self.type = type_
        self.all = 0
        for value in type_:
            self.all |= int(value)

    if TYPE_CHECKING:
        @overload
        def __get__(self: Self, instance: None, owner: type) -> Self: ...
        @overload
        def __get__(self, instance: object, owner: type) -> Flags: ...
        def __get__(self, instance: Any, owner: type) -> Any: ...

    def read(self, instance: Any) -> Any:
        value = getattr(instance._native, self.name)
        return self.type(value) if value & ~self.all == 0 else value

    def split(self, names: str) -> List[str]:
        return names.split("|")


class Numbers(Field["npt.NDArray[Any]"]):
    """A descriptor of a field whose value is a list of numbers: a one-dimensional array that
    belongs to the object, so that its elements can be assigned."""

    def __init__(self, kind: Any, about: str) -> None:
        super().__init__(about)
        self.kind = np.dtype(kind)

    def read(self, instance: Any) -> Any:
        return getattr(instance, "_" + self.name)

    def __set__(self, instance: Any, value: Optional[npt.ArrayLike]) -> None:
        setattr(instance, "_" + self.name, self.converted(value))

    def converted(self, value: Any) -> npt.NDArray[Any]:
        if value is None:
            return np.empty(0, self.kind)
        _arguments.refuseMasked(value, self.name)
        try:
            given = np.asarray(value)
        except Exception as failure:
            raise TypeError("{}: a list of numbers is expected ({})".format(self.name, failure)) from failure
        if given.size == 0 and given.dtype.kind in "biuf":
            return np.empty(0, self.kind)
        if given.dtype.kind not in "biuf" or given.ndim == 0:
            raise TypeError("{}: a list of numbers is expected, not {}".format(self.name, _arguments.shown(value)))
        self.checkShape(given)
        with np.errstate(over="ignore"):  # numbers too large for float32 become infinite
            return np.array(given, self.kind).reshape(-1)

    def checkShape(self, given: npt.NDArray[Any]) -> None:
        """Accepts any shape; the numbers are read row by row."""


class Model(Numbers):
    """A descriptor of a field whose value is the entries of a model. A matrix of the shape of a model,
    a row, a column or a one-dimensional array can be assigned."""

    def checkShape(self, given: npt.NDArray[Any]) -> None:
        _arguments.checkModelShape(given, self.name, TypeError)


class Covariance(Numbers):
    """A descriptor of a field whose value is the entries of a square matrix. The matrix, a row, a
    column or a one-dimensional array can be assigned."""

    def checkShape(self, given: npt.NDArray[Any]) -> None:
        if not _arguments.isList(given):
            _arguments.checkSquare(given, self.name, TypeError)


class Scores(Numbers):
    """A descriptor of a field whose value is a list of numbers. A row, a column or a
    one-dimensional array can be assigned."""

    def checkShape(self, given: npt.NDArray[Any]) -> None:
        if given.dtype == np.bool_:
            raise TypeError("{}: numbers are expected, not bool, of which it is unknown whether True is good".format(self.name))
        if not _arguments.isList(given):
            raise TypeError("{}: N numbers are expected, N x 1 or 1 x N, not the shape {}".format(self.name, given.shape))


class Noise(Numbers):
    """A descriptor of a field whose value is one, three or six numbers for each match, which are read
    row by row. The number of numbers for each match is stored, too."""

    def __set__(self, instance: Any, value: Optional[npt.ArrayLike]) -> None:
        super().__set__(instance, value)
        setattr(instance, "_{}Columns".format(self.name), self.columns(np.shape(value) if value is not None else (0,)))

    @staticmethod
    def columns(shape: Tuple[int, ...]) -> int:
        """Returns how many numbers describe a match. Returns 0 if the shape does not determine this: for
        an empty array, for one dimension (the numbers are stored in this form), and for 1x3 and 1x6."""
        if len(shape) == 1 or 0 in shape or shape in ((1, 3), (1, 6)):
            return 0
        return shape[1] if len(shape) == 2 and shape[1] in (3, 6) else 1

    def checkShape(self, given: npt.NDArray[Any]) -> None:
        if given.ndim == 2 and given.shape[1] in (3, 6):
            return
        if not _arguments.isList(given):
            raise TypeError("{}: N, N x 3 or N x 6 numbers are expected, not the shape {}".format(self.name, given.shape))
