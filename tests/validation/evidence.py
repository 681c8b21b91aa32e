"""What unit and verification tests prove, as a table with their outcome."""
import re
import subprocess
import xml.etree.ElementTree as xml

# (what is shown, test by its ctest name without instance, what it asserts)
EVIDENCE = [
    ("1. Poisson", "PoissonOn.InvertsTheDiscreteLaplacianToRoundOff",
     "Laplacian of the solution = right-hand side to round-off"),
    ("", "Poisson.IsSecondOrder", "order 2 ± 0.05"),
    ("1. Divergence", "ProjectionStep.LeavesADivergenceAtRoundOff",
     "below 1e-13 over the spacing after one projection"),
    ("", "EveryModel.KeepsTheVelocityDivergenceFree",
     "the same in coupled steps, every law and scheme"),
    ("1. Momentum", "FlowOrder.IsSecondInTimeForThetaOneHalf", "order 2 ± 0.1 in time"),
    ("", "FlowOrder.IsSecondInSpaceAtASmallTimeStep", "order 2 ± 0.15 in space"),
    ("", "FlowOrder.IsSecondInSpaceAndTimeTogether", "order 2 ± 0.15"),
    ("", "FlowSteadyState.DoesNotDependOnTheTimeStepNorOnTheta", "to 1e-8"),
    ("2. Membrane", "EveryLaw.UniformStretchGivesTheClosedFormTensions",
     "patches of several (lambda1, lambda2), to 1e-13"),
    ("", "EveryLaw.SimpleShearGivesTheClosedFormTensions", "to 1e-13"),
    ("", "EveryLaw.VanishesUnderRigidMotion", "to 1e-12"),
    ("", "EveryLaw.HasNoNetForceAndNoNetTorque", "to 1e-12"),
    ("", "LawWithEnergy.ForceIsMinusTheGradientOfTheEnergy", "to 1e-7 of the largest force"),
    ("", "LawWithEnergy.TensionsAndEnergyGiveTheSameForceToRoundOff",
     "first Piola-Kirchhoff form = energy form, to 1e-12"),
    ("", "EveryLaw.InflatedRingCarriesItsHoopTension",
     "total radial force of an inflated ring, error at most 0.2 edge^2"),
    ("3. Transfer", "AnyPair.SpreadingConservesTheForce", "to 1e-12, both kernels"),
    ("", "AnyPair.SpreadAndInterpolateAreAdjoint", "to 1e-14, both kernels"),
    ("", "AnyScheme.PowerBalances", "power of the wall's force = power received by the fluid"),
    ("Ghost nodes", "ConvexShape.WalkFindsWhatBruteForceFindsToWithinAFacet",
     "inflated shapes; the side of every node is right"),
    ("", "FoldedShape.WalkFindsTheNearestOrAnotherIntercept",
     "collapsed-looking and random shapes"),
    ("", "Morph.UpdatedSidesAreTheFreshOnesThereAndBack",
     "ghost nodes updated step by step = found from scratch"),
    ("8. Threads", "EveryModel.OneAndTwoThreadsGiveTheSameBits", "state after 20 coupled steps"),
    ("9. Memory", "Advance.AllocatesNothing", "no allocation inside a step"),
    ("11. Bad input", "BadCases.AWrongValueIsReportedWithWhatIsAllowed",
     "wrong case files, each with its message"),
    ("", "BadCases.AWrongCombinationIsReportedWithWhatIsAllowed", "values that do not fit together"),
    ("", "BadCases.AWrongValueInSiIsReportedInTheUnitOfTheFile", "the same in SI units"),
    ("", "BadCases.AMissingKeyIsReportedWithWhatItTakes", "keys left out"),
    ("", "Fuzz.HostileValuesOfEveryKeyAreACaseOrAnInputError", "no crash, no hang"),
    ("", "Fuzz.TruncationAtAnyByteIsACaseOrAnInputError", "no crash, no hang"),
]


def pattern():
    return "|".join(name.replace(".", r"\.") for _, name, _ in EVIDENCE)


def run_tests(build, report_file):
    """Runs the tests above in a build directory and writes their outcome; False if it cannot."""
    command = ["ctest", "--test-dir", str(build), "-R", pattern(), "--output-junit",
               str(report_file.resolve())]
    try:
        subprocess.run(command, capture_output=True, check=False)
    except OSError:
        return False
    return report_file.exists()


def outcomes(report_file):
    """Test name without its instance -> list of outcomes ("run" means it passed)."""
    found = {}
    if report_file.exists():
        for case in xml.parse(report_file).getroot().iter("testcase"):
            found.setdefault(plain_name(case.get("name")), []).append(case.get("status"))
    return found


def plain_name(name):
    """Suite.Test of Instance/Suite.Test/parameter."""
    parts = re.split("/", name)
    return next(p for p in parts if "." in p)


def write(report, report_file):
    found = outcomes(report_file)
    table = []
    for point, name, claim in EVIDENCE:
        status = found.get(name, [])
        passed = sum(s == "run" for s in status)
        cell = report.check(name, 0 < passed == len(status), f"{passed} of {len(status)} pass")
        table.append([point, f"`{name}`", claim, cell])
    report.table(["point", "test", "asserts", ""], table)
