# SPDX-License-Identifier: MIT
"""polynomial.py - is a multiplier its formula for all inputs? By algebra, at any word length:

    polynomial.py NETLIST MODULE [TERMS LESS TOP SHIFT]

NETLIST is Yosys' JSON of gates, words that are added or multiplied, and cells of sepax_fa. p, or if
there is a port q p + q, must be, modulo 2^bits of p, the sum of TERMS (1) products a_k (b_k - LESS
(0)), the first factors lowest in a and b, and where there are such ports + c - d 2^SHIFT, with a
port q + c + d. Of each b_k the three bits from bit TOP on, by sign extension, are worth -2 ... 2;
without TOP b_k is any.

Each bit is a variable that is 0 or 1. The polynomial sum of 2^k p_k has the outputs of the last
cells replaced by their inputs, cell by cell, until the module's inputs alone are left: a full adder
by 2 carry + sum = a + b + c, which is linear, half adders likewise, other gates by their product
terms. What is left is one polynomial for each function, so it must be that of the formula.
Exit status 0: it is; 1: it is not, or the polynomial grows too large.
"""

import json
import sys

LIMIT = 200000  # terms


class Polynomial:
    """Sum of coefficients times products of bits, modulo 2^bits."""

    def __init__(self, bits):
        self.modulus = 1 << bits
        self.terms = {}  # frozenset of bits: coefficient
        self.of = {}  # bit: the terms that it is in

    def add(self, product, coefficient):
        value = (self.terms.get(product, 0) + coefficient) % self.modulus
        if value:
            if product not in self.terms:
                for bit in product:
                    self.of.setdefault(bit, set()).add(product)
            self.terms[product] = value
        elif product in self.terms:
            del self.terms[product]
            for bit in product:
                self.of[bit].discard(product)
        if len(self.terms) > LIMIT:
            raise ValueError("too many terms")

    def take(self, bit):
        """Remove what has the bit; return the factor beside it."""
        factor = {}
        for product in list(self.of.get(bit, ())):
            factor[product - {bit}] = self.terms[product]
            self.add(product, -self.terms[product])
        return factor

    def add_product(self, factor, linear):
        """Add factor * linear, a list of (coefficient, product)."""
        for product, coefficient in factor.items():
            for weight, other in linear:
                self.add(product | other, weight * coefficient)


def bit_of(bit):
    """A bit as a polynomial: constants are known."""
    if bit in ("0", "x"):
        return []
    return [(1, frozenset() if bit == "1" else frozenset([bit]))]


def scaled(linear, weight):
    return [(weight * coefficient, product) for coefficient, product in linear]


def times(x, y):
    return [(a * b, p | q) for a, p in x for b, q in y]


def word(bits, signed, weight=1):
    """What a word is worth."""
    total = []
    for place, bit in enumerate(bits):
        sign = -1 if signed and place == len(bits) - 1 else 1
        total += scaled(bit_of(bit), sign * weight << place)
    return total


GATES = {  # in x, y
    "$_AND_": lambda x, y: times(x, y),
    "$_OR_": lambda x, y: x + y + scaled(times(x, y), -1),
    "$_XOR_": lambda x, y: x + y + scaled(times(x, y), -2),
    "$_XNOR_": lambda x, y: [(1, frozenset())] + scaled(x + y, -1) + scaled(times(x, y), 2),
    "$_ANDNOT_": lambda x, y: x + scaled(times(x, y), -1),
    "$_NAND_": lambda x, y: [(1, frozenset())] + scaled(times(x, y), -1),
    "$_NOR_": lambda x, y: [(1, frozenset())] + scaled(x + y, -1) + times(x, y),
}


class Netlist:
    """Steps, each of which gives bits from others."""

    def __init__(self, module):
        self.ports = {n: p["bits"] for n, p in module["ports"].items()}
        self.steps = []  # (how, outputs, inputs)
        ands, xors = {}, {}
        for cell in module["cells"].values():
            kind, at = cell["type"], cell["connections"]
            if "sepax_fa" in kind:
                for a, b, c, total, carry in zip(at["a"], at["b"], at["c"], at["sum"], at["carry"]):
                    self.steps.append(("full", [total, carry], [a, b, c]))
            elif kind in ("$add", "$sub", "$mul"):
                self.steps.append((cell, at["Y"], at["A"] + at["B"]))
            elif kind == "$_NOT_":
                self.steps.append(("not", at["Y"], at["A"]))
            elif kind == "$_DFF_P_":
                for d, q in zip(at["D"], at["Q"]):
                    self.steps.append(("register", [q], [d]))
            elif kind in GATES:
                inputs = (at["A"][0], at["B"][0])
                if kind in ("$_AND_", "$_OR_"):
                    ands.setdefault(frozenset(inputs), []).append((kind, at["Y"][0], inputs))
                elif kind == "$_XOR_":
                    xors.setdefault(frozenset(inputs), []).append((at["Y"][0], inputs))
                else:
                    self.steps.append((kind, at["Y"], list(inputs)))
            else:
                raise ValueError("cell of kind " + kind)
        for key, same in xors.items():
            carry = ands.get(key, [])
            if len(same) == 1 and len(carry) == 1:  # a half adder
                kind, bit, inputs = carry[0]
                ands.pop(key)
                self.steps.append(("half" + kind, [same[0][0], bit], list(inputs)))
            else:
                self.steps += [("$_XOR_", [bit], list(inputs)) for bit, inputs in same]
        for same in ands.values():
            self.steps += [(kind, [bit], list(inputs)) for kind, bit, inputs in same]

    def backward(self):
        """The steps, each behind those that use what it gives."""
        maker = {bit: step for step in self.steps for bit in step[1]}
        state, order = {}, []
        for first in self.steps:
            stack = [(first, False)]
            while stack:
                step, done = stack.pop()
                if done:
                    order.append(step)
                elif id(step) not in state:
                    state[id(step)] = True
                    stack.append((step, True))
                    stack += [(maker[bit], False) for bit in step[2] if bit in maker]
        age = {}  # cycles from the inputs to a bit
        for how, outputs, inputs in order:
            ages = {age.get(bit, 0) for bit in inputs if not isinstance(bit, str)}
            if len(ages) > 1:
                raise ValueError("bits of different cycles meet")
            if ages:
                late = ages.pop() + (how == "register")
                age.update({bit: late for bit in outputs})
        if len({age.get(bit, 0) for bit in self.ports["p"] if not isinstance(bit, str)}) > 1:
            raise ValueError("bits of p come in different cycles")
        return reversed(order)


def weighted(factors, modulus, signed):
    """The factor of bit 0, if bit k has 2^k times that; of a signed word the highest -2^k."""
    for place, factor in enumerate(factors):
        sign = -1 if signed and place == len(factors) - 1 else 1
        wanted = {p: (sign * c << place) % modulus for p, c in factors[0].items()}
        if {p: c for p, c in wanted.items() if c} != factor:
            return None
    return factors[0]


def replace(total, step):
    """Put the inputs of a step in the place of its outputs."""
    how, outputs, inputs = step
    if isinstance(how, dict):
        factors = [total.take(bit) for bit in outputs]
        of = how["parameters"]
        is_signed = int(of["A_SIGNED"], 2) and int(of["B_SIGNED"], 2)
        a = word(how["connections"]["A"], is_signed)
        b = word(how["connections"]["B"], is_signed)
        factor = weighted(factors, total.modulus, False)
        if factor is not None:
            if any((c << len(outputs)) % total.modulus for c in factor.values()):
                bits = len(how["connections"]["A"]) + len(how["connections"]["B"])
                if is_signed or how["type"] != "$mul" or len(outputs) < bits:
                    raise ValueError("a word that wraps")
        else:
            factor = weighted(factors, total.modulus, True)
            bits = len(how["connections"]["A"]) + len(how["connections"]["B"])
            if factor is None or how["type"] != "$mul" or not is_signed or len(outputs) < bits:
                raise ValueError("bits of a word with weights of their own")
        value = times(a, b) if how["type"] == "$mul" else a + (
            b if how["type"] == "$add" else scaled(b, -1))
        total.add_product(factor, value)
        return
    bits = [bit_of(bit) for bit in inputs]
    if how == "full" or how.startswith("half"):
        of_sum, of_carry = total.take(outputs[0]), total.take(outputs[1])
        sign = -1 if how == "half$_OR_" else 1  # 2 (x | y) - (x ^ y) = x + y
        twice = {p: (sign * 2 * c) % total.modulus for p, c in of_sum.items()}
        if {p: c for p, c in twice.items() if c} == of_carry:
            total.add_product(of_sum, scaled([term for bit in bits for term in bit], sign))
            return
        x, y = bits[0], bits[1]
        half = GATES["$_XOR_"](x, y)
        if how == "full":
            total.add_product(of_sum, GATES["$_XOR_"](half, bits[2]))
            total.add_product(of_carry, times(x, y) + times(half, bits[2]))
        else:
            total.add_product(of_sum, half)
            total.add_product(of_carry, GATES[how[4:]](x, y))
        return
    factor = total.take(outputs[0])
    if how == "not":
        total.add_product(factor, [(1, frozenset())] + scaled(bits[0], -1))
    elif how == "register":
        total.add_product(factor, bits[0])
    else:
        total.add_product(factor, GATES[how](bits[0], bits[1]))


def spec(ports, terms, less, top, shift):
    """The formula's polynomial, and of each b_k the three bits that are not -4, -3 or 3."""
    value, tops = word(ports.get("c", []), True), []
    value += word(ports.get("d", []), True, 1 if "q" in ports else -1 << shift)
    a_bits, b_bits = len(ports["a"]) // terms, len(ports["b"]) // terms
    for k in range(terms):
        a = ports["a"][k * a_bits:(k + 1) * a_bits]
        b = ports["b"][k * b_bits:(k + 1) * b_bits]
        value += times(word(a, True), word(b, True) + [(-less, frozenset())])
        if top:
            tops.append((b + [b[-1]] * 3)[top:top + 3])
    return value, tops


def within(total, top):
    """Use that the three bits are worth -2 ... 2: of 4 - 2, 4 - 1 and not 4, both others 0."""
    low, middle, high = top
    for product in list(total.terms):
        new = product
        if high != middle and high in new and middle in new:
            new = new - {middle}
        elif len({low, middle, high}) == 3 and low in new and middle in new:
            new = (new - {middle}) | {high}
        if new != product:
            coefficient = total.terms[product]
            total.add(product, -coefficient)
            total.add(new, coefficient)


def main():
    with open(sys.argv[1], encoding="ascii") as file:
        netlist = Netlist(json.load(file)["modules"][sys.argv[2]])
    output = netlist.ports["p"]
    total = Polynomial(len(output))
    for weight, product in word(output, False) + word(netlist.ports.get("q", []), False):
        total.add(product, weight)
    for step in netlist.backward():
        replace(total, step)
    terms, less, top, shift = [int(n) for n in sys.argv[3:]] or [1, 0, 0, 0]
    value, tops = spec(netlist.ports, terms, less, top, shift)
    for coefficient, product in value:
        total.add(product, -coefficient)
    for top in tops:
        within(total, top)
    if total.terms:
        print(f"{len(total.terms)} terms differ from the formula")
        return 1
    print("proved")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except ValueError as error:
        print(error)
        sys.exit(1)
