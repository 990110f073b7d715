# SPDX-License-Identifier: BSD-3-Clause
"""Nodes as functions of n and r: equations 14 and 15 beside what is counted, and fitted exponents."""
import numpy as np
from cells import Table
from node_tables import of
from plan import BOUNDED, PRINTED, TREE, UNBOUNDED
from scipy.special import comb

FITTED = (UNBOUNDED, BOUNDED, PRINTED, TREE)
LEAST = 8  # searches of a fit


def equation_14(n, r):
    """Leaves of JCBB: 2^n - sum over 1..r of 2^(n-i), which is 2^(n-r)."""
    return 2.0 ** (np.asarray(n) - np.asarray(r))


def equation_15(n, r):
    """Leaves of HOHCT as the paper has them: sum over 1..r of n^i."""
    return sum(float(n) ** i for i in range(1, int(r) + 1))


def hohct_leaves(n, r):
    """As they are: one for each subset of up to r pairs."""
    return sum(comb(int(n), i) for i in range(1, int(r) + 1))


def hohct_nodes(n, r):
    """Of Algorithm 1, with its inner nodes."""
    return sum(comb(int(n) + 1, i) for i in range(1, int(r) + 1))


def over(function, rows):
    return float(np.mean([function(n, r) for n, r in zip(rows.n, rows.r)]))


def equations(problems):
    """Means over the searches of one r; searches that reached a cap are left out."""
    printed = of(problems, PRINTED)
    printed = printed[printed.proved == 1]
    unbounded = of(problems, UNBOUNDED)
    unbounded = unbounded[unbounded.proved == 1]
    rows = []
    for r in sorted(printed.r.unique()):
        mine, other = printed[printed.r == r], unbounded[unbounded.r == r]
        rows.append({"r": str(r), "searches": len(mine), "mean n": mine.n.mean(),
                     "HOHCT leaves": mine.leaves.mean(), "sum C(n,i)": over(hohct_leaves, mine),
                     "eq. 15": over(equation_15, mine), "HOHCT nodes": mine.nodes.mean(),
                     "sum C(n+1,i)": over(hohct_nodes, mine),
                     "JCBB, no bound: leaves": other.leaves.mean(),
                     "eq. 14": over(equation_14, other), "JCBB nodes": other.nodes.mean()})
    return Table("equations", "Counted and predicted", rows)


def line(x, y):
    """Least squares of y on the columns of x and a constant: coefficients, R^2."""
    design = np.column_stack([*x, np.ones(len(y))])
    solution = np.linalg.lstsq(design, y, rcond=None)[0]
    rest = np.sum((y - design @ solution) ** 2)
    spread = np.sum((y - y.mean()) ** 2)
    return solution, 1.0 - rest / spread if spread > 0 else np.nan


def growth(problems):
    """log2(nodes) = a + b n + c r: nodes grow 2^b-fold with a pair, 2^c-fold with a rejected one."""
    rows = []
    for method in FITTED:
        mine = of(problems, method)
        mine = mine[mine.proved == 1]
        enough = len(mine) >= LEAST and mine.n.nunique() > 1 and mine.r.nunique() > 1
        fit, quality = line((mine.n, mine.r), np.log2(mine.nodes)) if enough else ([np.nan] * 3,
                                                                                   np.nan)
        rows.append({"method": method.title, "searches": len(mine),
                     "nodes, a pair more": 2 ** fit[0], "nodes, a rejected pair more": 2 ** fit[1],
                     "R2": quality})
    return Table("growth", "Growth of the nodes with n and r", rows)


def exponents(problems):
    """nodes ~ n^k, for each number of rejected pairs that has enough searches."""
    rows = []
    for method in FITTED:
        mine = of(problems, method)
        mine = mine[mine.proved == 1]
        row = {"method": method.title, "searches": len(mine)}
        for r in (1, 2, 3):
            some = mine[mine.r == r]
            enough = len(some) >= LEAST and some.n.nunique() > 1
            row[f"r = {r}"] = line((np.log(some.n),), np.log(some.nodes))[0][0] if enough else np.nan
        enough = len(mine) >= LEAST and mine.n.nunique() > 1
        row["all"] = line((np.log(mine.n),), np.log(mine.nodes))[0][0] if enough else np.nan
        rows.append(row)
    return Table("exponents", "Exponents k of nodes ~ n^k", rows)
