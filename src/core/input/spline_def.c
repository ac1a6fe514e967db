// SPDX-License-Identifier: MIT
#include "core/input/spline.h"

#define SW_DEF swSplinePoint
static const swField pointFields[] = {
    SW_NUMBER(x, "m", SW_WITHIN(-1e9, 1e9), 0.0, .key = "x_m", .label = "x"),
    SW_NUMBER(z, "m", SW_WITHIN(-1e9, 1e9), 0.0, .key = "z_m", .label = "z"),
    SW_NUMBER(y, "m", SW_WITHIN(-1e6, 1e6), 0.0, .key = "y_m", .label = "height", SW_KNOB(-10.0, 10.0)),
    SW_NUMBER(width, "", SW_WITHIN(0.0, 100.0), 1.0, .key = "width", .label = "width",
              .tip = "Factor on the spline's width", SW_KNOB(0.0, 4.0)),
    SW_NUMBER(weight, "", SW_WITHIN(0.0, 10.0), 1.0, .key = "weight", .label = "weight",
              .tip = "Factor on how much of an input counts", SW_KNOB(0.0, 1.0)),
    SW_NUMBER(flow, "m/s", SW_WITHIN(-100.0, 100.0), 2.0, .key = "flow_m_per_s", .label = "flow",
              .tip = "Along the line; below 0 against it", SW_KNOB(-5.0, 5.0)),
    SW_NUMBER(foam, "1/s", SW_WITHIN(0.0, 100.0), 1.0, .key = "foam_per_s", .label = "foam", SW_KNOB(0.0, 5.0)),
    SW_NUMBER(level, "m", SW_WITHIN(-1e4, 1e4), 0.0, .key = "level_m", .label = "level",
              .tip = "Of still water above the point", SW_KNOB(-5.0, 5.0)),
    SW_NUMBER(depth, "m", SW_WITHIN(-1e4, 1e4), 0.0, .key = "depth_m", .label = "depth",
              .tip = "Of the sea floor under the point", SW_KNOB(0.0, 10.0)),
};
#undef SW_DEF

const swFields swSplinePointFields = SW_PART_FIELDS(swSplinePoint, "spline_points", "point of a spline", pointFields);

static const char* const offsetWords[] = {"centre", "left", "right", NULL};
static const char* const offsetNames[] = {"both sides", "left of the line", "right of the line", NULL};

#define SW_DEF swSplineDef
static const swField splineFields[] = {
    SW_GIVEN(name, .label = "name"),
    SW_LIST(points, pointCount, SW_MAX_SPLINE_POINTS, &swSplinePointFields, .key = NULL, .label = "points"),
    SW_SWITCH(isClosed, 0.0, .key = "closed", .label = "closed", .tip = "The last point leads on to the first"),
    SW_CHOICE(offset, offsetWords, offsetNames, SW_SPLINE_CENTRE, .key = "offset", .label = "ribbon"),
    SW_NUMBER(width, "m", SW_WITHIN(0.01, 1e4), 20.0, .key = "width_m", .label = "width", SW_LOG_KNOB(1.0, 1000.0)),
    SW_NUMBER(startRamp, "m", SW_WITHIN(0.0, 1e5), 0.0, .key = "start_ramp_m", .label = "ramp at the start",
              SW_KNOB(0.0, 100.0)),
    SW_NUMBER(endRamp, "m", SW_WITHIN(0.0, 1e5), 0.0, .key = "end_ramp_m", .label = "ramp at the end",
              SW_KNOB(0.0, 100.0)),
};
#undef SW_DEF

const swFields swSplineFields = SW_FIELDS(swSplineDef, "splines", "spline", splineFields, -1);

const swFields* swGetSplinePointFields(void)
{
    return &swSplinePointFields;
}

const swFields* swGetSplineFields(void)
{
    return &swSplineFields;
}

swSplinePoint swDefaultSplinePoint(double x, double y, double z)
{
    swSplinePoint point;
    swFillDef(&swSplinePointFields, &point);
    point.x = x;
    point.y = y;
    point.z = z;
    return point;
}

swSplineDef swDefaultSplineDef(void)
{
    swSplineDef def;
    swFillDef(&swSplineFields, &def);
    def.name = "spline";
    return def;
}
