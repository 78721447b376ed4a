#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the seeds of the fuzz targets of maps, coefficients, clocks, antennas, biases and coordinates: small made files."""
import pathlib

HERE = pathlib.Path(__file__).resolve().parent / "corpus"


def head(text, label):
    return f"{text:<60.60}{label}\n"


def ionex(heights=1, kinds=("TEC",), extra="", exponent=""):
    out = head("     1.0            IONOSPHERE MAPS     GNSS", "IONEX VERSION / TYPE")
    out += head("made                nobody              01-JAN-24 00:00", "PGM / RUN BY / DATE")
    out += head("Made", "DESCRIPTION") + head("  2024     2     4     0     0     0", "EPOCH OF FIRST MAP")
    out += head("  2024     2     4     2     0     0", "EPOCH OF LAST MAP") + head("  7200", "INTERVAL")
    out += head("     2", "# OF MAPS IN FILE") + head("  COSZ", "MAPPING FUNCTION") + head("    10.0", "ELEVATION CUTOFF")
    out += head("  6371.0", "BASE RADIUS") + head(f"     {3 if heights > 1 else 2}", "MAP DIMENSION")
    out += head(f"   450.0{400 + 50.0 * heights:6.1f}  50.0", "HGT1 / HGT2 / DHGT")
    out += head("    10.0 -10.0 -20.0", "LAT1 / LAT2 / DLAT") + head("  -180.0 160.0  20.0", "LON1 / LON2 / DLON")
    out += head("    -1", "EXPONENT") + extra + head("", "END OF HEADER")
    for kind in kinds:
        for number in (1, 2):
            out += head(f"{number:6d}", f"START OF {kind} MAP")
            out += head(f"  2024     2     4{2 * number - 2:6d}     0     0", "EPOCH OF CURRENT MAP") + exponent
            for h in range(heights):
                for lat in (10.0, -10.0):
                    out += head(f"  {lat:6.1f}-180.0 160.0  20.0{450 + 50.0 * h:6.1f}", "LAT/LON1/LON2/DLON/H")
                    values = [f"{(9999 if k == 3 else 100 * number + k):5d}" for k in range(18)]
                    out += "".join(values[:16]) + "\n" + "".join(values[16:]) + "\n"
            out += head(f"{number:6d}", f"END OF {kind} MAP")
    return out + head("", "END OF FILE")


AUX = (head("DIFFERENTIAL CODE BIASES", "START OF AUX DATA") + head("   G01    -7.047     0.051", "PRN / BIAS / RMS")
       + head("   G  BOR1 12205M002           8.609     0.107", "STATION / BIAS / RMS")
       + head("DIFFERENTIAL CODE BIASES", "END OF AUX DATA"))


def ion():
    out = ""
    for k in range(2):
        out += "GLOBAL IONOSPHERE MODEL\n" + "-" * 80 + "\n"
        for label, value in (
                ("MODEL NUMBER / STATION NAME", f" 0350-{k:02d}"), ("MODEL TYPE (1=LOCAL,2=GLOBAL,3=STATION)", "    2"),
                ("MAXIMUM DEGREE OF SPHERICAL HARMONICS", "    2"), ("MAXIMUM ORDER", "    2"),
                ("  GEOGRAPHICAL (=1) OR GEOMAGNETIC (=2) FRAME", "    2"),
                ("  MEAN (=1) OR TRUE (=2) POSITION OF THE SUN", "    1"),
                ("MAPPING FUNCTION (0=NONE,1=COSZ,2=MSLM,3=ESM)", "    2"),
                ("HEIGHT OF SINGLE LAYER AND ITS RMS ERROR (KM)", "  450.00     0.00"),
                ("  LATITUDE OF NORTH GEOMAGNETIC POLE (DEGREES)", "   80.65"), ("  EAST LONGITUDE (DEGREES)", "  -72.68"),
                ("  FROM EPOCH / REFERENCE EPOCH (Y,M,D,H,M,S)", f" 2024 02 04 {k:02d} 00 00"), ("  TO EPOCH", ""),
                ("  MAXIMUM TEC AND ITS RMS ERROR (TECU)", "  113.19     0.33"), ("COMMENT / WARNING", "")):
            out += f"{label:<47}:{value}\n"
        out += "COEFFICIENTS\nDEGREE  ORDER    VALUE (TECU)   RMS (TECU)\n"
        for n in range(3):
            for m in range(n + 1):
                for order in ((m, -m) if m else (0,)):
                    out += f"{n:4d}{order:8d}{20.5 - n + 0.1 * order:18.8f}{0.0123:11.4f}\n"
        out += "\n"
    return out


ERP_IGS = """version 2
Source: made

  MJD      Xpole   Ypole  UT1-UTC    LOD  Xsig  Ysig   UTsig  LODsig  Nr Nf Nt    Xrt    Yrt  Xrtsig  Yrtsig
             (10**-6")       (0.1 usec)    (10**-6")     (0.1 usec)              (10**-6"/d)    (10**-6"/d)
59830.50  301078  310229   -98409  -1857    22  10     135      23   0  0  0  -1430  -3058     66     55
59831.50  301079  310230   -98410  -1858    22  10     135      23   0  0  0  -1430  -3058     66     55
"""
ERP_TAI = """version 2
made
  MJD     Xpole  Ypole UT1 -TAI   LOD  Xsig Ysig UTsig LODsig Nr Nf Nt X-RT Y-RT X-RTsig Y-RTsig
          E-6"   E-6"   .1 us  .1 us/d E-6" E-6" .1 us .1 us/d           E-6" E-6" E-6" E-6"
60582.500 225415 411006 -369409348 -301 4 4 11 11 128 99 78 520 -2158 16 17
"""


def clk(version):
    wide = version == "3.04"
    pad = 65 if wide else 60
    out = f"{'     ' + version + '           C                   M':<{pad}}RINEX VERSION / TYPE\n"
    out += f"{'   GPS':<{pad}}TIME SYSTEM ID\n{'    18':<{pad}}LEAP SECONDS\n{'':<{pad}}END OF HEADER\n"
    for k in range(3):
        name = "BRUX00BEL" if wide else "BRUX"
        out += f"AR {name} 2024 02 04 00 {k:02d}  0.000000  2    0.{k + 1}00000000000E-08  0.300000000000E-10\n"
        out += f"AS G30  2024  2  4  0 {k:2d}  0.000000  1    0.{k + 1}00419332247E-03\n"
    out += "AS R05  2024 02 04 00 00  0.000000  6   -0.1D-03 0.1D+01\n  -0.1D+02 0.1D+03 -0.1D+04 0.1D+05\n"
    return out + "DR USNO 2024 02 04 00 00  0.000000  1   -0.123456789012E+00\n"


def antex(dazi):
    out = head("     1.4            M", "ANTEX VERSION / SYST") + head("A", "PCV TYPE / REFANT") + head("", "END OF HEADER")
    for name in ("BLOCK IIR-M         G01                 G049      2009-014A", "TRM59800.00     NONE"):
        out += head("", "START OF ANTENNA") + head(name, "TYPE / SERIAL NO") + head(f"{dazi:8.1f}", "DAZI")
        out += head("     0.0   4.0   2.0", "ZEN1 / ZEN2 / DZEN") + head("     1", "# OF FREQUENCIES")
        out += head("  2009     3    24     0     0    0.0000000", "VALID FROM") + head("   G01", "START OF FREQUENCY")
        out += head("    279.00     -1.50    963.20", "NORTH / EAST / UP") + "   NOAZI   10.70   10.10    8.00\n"
        if dazi:
            for az in range(0, 361, int(dazi)):
                out += f"{az:8.1f}   10.70   10.10    8.00\n"
        out += head("   G01", "END OF FREQUENCY") + head("   G01", "START OF FREQ RMS")
        out += head("      0.10      0.20      0.30", "NORTH / EAST / UP") + head("   G01", "END OF FREQ RMS")
        out += head("", "END OF ANTENNA")
    return out


BIAS = """%=BIA 1.00 COD 2024:040:29169 IGS 2024:035:00000 2024:036:00000 A 00000003
+BIAS/DESCRIPTION
 BIAS_MODE                               ABSOLUTE
 TIME_SYSTEM                             G
-BIAS/DESCRIPTION
+BIAS/SOLUTION
 OSB  G063 G01           C1C       2024:035:00000 2024:036:00000 ns                  9.5198      0.0001
 OSB  G063 G01           C1W       2024:035:00000 2024:036:00000 ns                 11.0188      0.0002 1.000000000000000E-05 1.00000E-06
 DSB  G063 G01           C1C  C2W  2024:035:00000 2024:036:00000 ns                 -1.5000      0.0300
 OSB  G063 G01           L1C       2024:035:00000 2024:036:00000 cyc                 0.2500      0.0000
 DSB       G   BOR1      C1C  C1W  2024:035:00000 0000:000:00000 ns                  2.0000      0.0300
-BIAS/SOLUTION
%=ENDBIA
"""
DCB = """CODE'S MONTHLY GNSS P1-P2 DCB SOLUTION, YEAR-MONTH 08-12         06-JAN-09 10:45
--------------------------------------------------------------------------------

DIFFERENTIAL (P1-P2) CODE BIASES FOR SATELLITES AND RECEIVERS:

PRN / STATION NAME        VALUE (NS)  RMS (NS)
***   ****************    *****.***   *****.***
G01                          -1.582       0.009
G02                          -1.582       0.009  2020 12 24 00 00 00  2020 12 25 00 00 00
R     ABPO 33302M001         -4.500       0.100
"""
SINEX = """%=SNX 2.02 IGN 24:053:83755 IGN 24:035:00000 24:036:00000 C  1484 2 S E
+SITE/ID
 BOR1  A 12205M002 P Borowiec, POLAND        17 04 24.4  52 16 37.0   124.3
-SITE/ID
+SITE/ECCENTRICITY
 BOR1  A ---- P 99:169:00000 00:000:00000 UNE   0.0624   0.0010  -0.0020
-SITE/ECCENTRICITY
+SOLUTION/ESTIMATE
     1 STAX   BOR1  A    1 24:035:43200 m    2  3.73835813450000e+06 1.10000e-03
     2 STAY   BOR1  A    1 24:035:43200 m    2  1.14817400900000e+06 1.20000e-03
     3 STAZ   BOR1  A    1 24:035:43200 m    2  5.02181593570000e+06 1.30000e-03
     4 VELX   BOR1  A    1 24:035:43200 m/y  2 -1.73000000000000e-02 1.00000e-05
-SOLUTION/ESTIMATE
%ENDSNX
"""


# The IERS' own tables: finals2000A by columns, C04 in the forms of 14 and of 20.
FINALS = "".join(
    f"24{12:2d}{mjd - 60644:2d} {mjd:5d}.00 {kind}  0.123456 0.000091  0.234567 0.000092  "
    f"{kind}-0.0123456 0.0000123  0.7654 0.0045  P     0.123    0.128    -0.456    0.160\n"
    for mjd, kind in ((60651, "I"), (60652, "I"), (60653, "P"), (60658, "P"))) + "241215 60659.00\n"
C04_14 = """                             EARTH ORIENTATION PARAMETER (EOP) PRODUCT CENTER
                                          EOP (IERS) 14 C04
      Date      MJD      x          y        UT1-UTC       LOD         dX        dY        x Err
                         "          "           s           s
1962   1   1  37665  -0.012700   0.213000   0.0326338   0.0017230   0.000000   0.000000   0.030000   0.030000  0.0020000  0.0014000    0.012000    0.002000
2019   3   4  58546   0.055555   0.366666  -0.0876543   0.0009876   0.000111  -0.000222   0.000033   0.000044  0.0000055  0.0000066    0.000077    0.000088
2019   3   5  58547   0.055666   0.366777  -0.0881111   0.0009876   0.000111  -0.000222   0.000033   0.000044  0.0000055  0.0000066    0.000077    0.000088
"""
C04_20 = """# EOP (IERS) 20 C04 TIME SERIES  consistent with ITRF 2020
# YR  MM  DD  HH       MJD        x(")        y(")  UT1-UTC(s)       dX(")      dY(")       xrt(")
2019   3   4   0  58546.00    0.055555    0.366666  -0.0876543    0.000111   -0.000222    0.001230   -0.002340   0.0009876    0.000033    0.000044   0.0000055    0.000077    0.000088    0.000099    0.000091   0.0000066
2019   3   4  12  58546.50    0.055666    0.366777  -0.0881111    0.000111   -0.000222    0.001230   -0.002340   0.0009876    0.000033    0.000044   0.0000055    0.000077    0.000088    0.000099    0.000091   0.0000066
"""
METADATA = """%=SNX 2.02 XXX 24:001:00000 XXX 00:000:00000 00:000:00000 P 00000 0
+SATELLITE/IDENTIFIER
*SVN_ COSPAR ID SatCat Block__________ Comment
 G063 2011-036A  37753 GPS-IIF         made
 R730 2009-070A  36111 GLO-M           made
-SATELLITE/IDENTIFIER
+SATELLITE/PRN
*SVN_ Valid_From____ Valid_To______ PRN Comment
 G035 1993:243:00000 2011:196:00000 G01
 G063 2011:197:00000 0000:000:00000 G01 made
 R730 2009:348:00000 0000:000:00000 R01
-SATELLITE/PRN
+SATELLITE/FREQUENCY_CHANNEL
 R730 2009:348:00000 0000:000:00000   1
-SATELLITE/FREQUENCY_CHANNEL
+SATELLITE/TX_POWER
*SVN_ Valid_From____ Valid_To______ P[W] Comment
 G063 2011:197:00000 0000:000:00000  240 made
-SATELLITE/TX_POWER
%ENDSNX
"""


def main():
    seeds = {
        "ionex/tec": ionex(), "ionex/all_kinds": ionex(kinds=("TEC", "RMS", "HEIGHT"), extra=AUX),
        "ionex/three_dimensional": ionex(heights=2, exponent=head("    -2", "EXPONENT")),
        "ion/two_models": ion(), "erp/igs": ERP_IGS, "erp/tai": ERP_TAI, "erp/both": ERP_TAI + ERP_IGS,
        "erp/finals": FINALS, "erp/c04_14": C04_14, "erp/c04_20": C04_20,
        "clk/v300": clk("3.00"), "clk/v200": clk("2.00"), "clk/v304": clk("3.04"),
        "antex/plain": antex(0.0), "antex/azimuths": antex(90.0), "bias/sinex": BIAS, "bias/dcb": DCB, "sinex/station": SINEX,
        "satellite_metadata/igs": METADATA,
    }
    for name, text in seeds.items():
        path = HERE / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


if __name__ == "__main__":
    main()
