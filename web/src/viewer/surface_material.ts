import { Color, DoubleSide, LessEqualDepth, ShaderMaterial } from 'three';

export interface SurfaceColors {
    body: string;
    rim: string;
    /** Opacity where the surface faces the viewer. */
    bodyOpacity: number;
    /** Opacity where it turns away: the outline stays readable while the inside shows through. */
    rimOpacity: number;
}

const kVertexShader = /* glsl */ `
    #include <common>
    #include <skinning_pars_vertex>
    #include <clipping_planes_pars_vertex>
    varying vec3 normal_view;
    varying vec3 to_viewer;
    #ifdef USE_COLOR
        varying vec3 own_color;
    #endif
    void main() {
        #ifdef USE_COLOR
            own_color = color;
        #endif
        #include <beginnormal_vertex>
        #include <skinbase_vertex>
        #include <skinnormal_vertex>
        #include <begin_vertex>
        #include <skinning_vertex>
        vec4 mvPosition = modelViewMatrix * vec4(transformed, 1.0);
        normal_view = normalMatrix * objectNormal;
        // Rays of an orthographic camera are parallel.
        to_viewer = isOrthographic ? vec3(0.0, 0.0, 1.0) : -mvPosition.xyz;
        gl_Position = projectionMatrix * mvPosition;
        #include <clipping_planes_vertex>
    }
`;

const kFragmentShader = /* glsl */ `
    #include <clipping_planes_pars_fragment>
    uniform vec3 body;
    uniform vec3 rim;
    uniform float body_opacity;
    uniform float rim_opacity;
    varying vec3 normal_view;
    varying vec3 to_viewer;
    #ifdef USE_COLOR
        varying vec3 own_color;
    #endif
    void main() {
        #include <clipping_planes_fragment>
        #ifdef USE_COLOR
            vec3 body_color = own_color;
            vec3 rim_color = 0.45 * own_color;
        #else
            vec3 body_color = body;
            vec3 rim_color = rim;
        #endif
        float facing = abs(dot(normalize(normal_view), normalize(to_viewer)));
        float edge = pow(1.0 - facing, 2.2);
        float light = 0.82 + 0.18 * normalize(normal_view).y * (gl_FrontFacing ? 1.0 : -1.0);
        gl_FragColor = vec4(mix(body_color, rim_color, edge) * light, mix(body_opacity, rim_opacity, edge));
        #include <colorspace_fragment>
    }
`;

/** Opacity of a surface in its file's colours: they are to be seen, and the skeleton through them. */
const kColoredOpacity = { body: 0.72, rim: 0.95 };

/**
 * Glass rather than plain transparency: opaque at the silhouette, clear where one looks straight at
 * it. Both faces are drawn, because the triangles of a polygon soup are wound at random.
 * `ownColors`: by the geometry's attribute `color`, linear, instead of the body's; as opaque as they are
 * to be seen, unless another `opacity` is given.
 */
export function surfaceMaterial(
    colors: SurfaceColors,
    ownColors = false,
    opacity: number | null = null,
): ShaderMaterial {
    const asColored = ownColors && opacity === null;
    return new ShaderMaterial({
        vertexShader: kVertexShader,
        fragmentShader: kFragmentShader,
        uniforms: {
            body: { value: new Color(colors.body) },
            rim: { value: new Color(colors.rim) },
            body_opacity: { value: asColored ? kColoredOpacity.body : colors.bodyOpacity },
            rim_opacity: { value: asColored ? kColoredOpacity.rim : colors.rimOpacity },
        },
        vertexColors: ownColors,
        transparent: true,
        depthWrite: false,
        depthFunc: LessEqualDepth,
        side: DoubleSide,
        clipping: true,
    });
}
