// Written by `npm run api` from server/openapi.yaml: change that one.

export interface paths {
    "/v1/search": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Rank the collection against an uploaded model
         * @description The body is a model file (OFF and its relatives, STL, OBJ, PLY, 3MF, glTF, COLLADA, X3D, AMF,
         *     FBX, STEP or IGES, points, a volume, or any of them packed by gzip or in a ZIP archive), raw or as the
         *     field `model` of a multipart form; the format follows the contents. Nothing is written to a disk; the answer's
         *     `token` leads to the upload while the server keeps it in memory (`/v1/queries/{token}`).
         */
        post: operations["search"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/progress/{token}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Which stage a search is in
         * @description Answered at once however many searches run. A search whose client closes the connection is given up.
         */
        get: operations["getProgress"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/queries/{token}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        /**
         * An upload that was searched with
         * @description Every answer of `POST /v1/search` names a token under which the server keeps the upload, in memory alone, until
         *     a quarter of an hour after it was last asked for or until later ones need its room; then `query_not_found`.
         */
        get: operations["getQuery"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/queries/{token}/similar": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        /** Rank the collection against a kept upload */
        get: operations["similarToQuery"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/queries/{token}/mesh": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        /** The upload's preview mesh, at most 2,000 triangles */
        get: operations["queryMesh"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/queries/{token}/skeleton": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        /** The upload's refined skeleton with its chain codes */
        get: operations["querySkeleton"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/queries/{token}/segments": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        /**
         * The upload's parts
         * @description As those of a model; found when first asked for.
         */
        get: operations["querySegments"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/queries/{token}/rig.glb": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        /**
         * The upload with joints to move it by
         * @description As that of a model.
         */
        get: operations["queryRig"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/queries/{token}/mesh.stl": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        /**
         * The upload as binary STL
         * @description All of its triangles, for programs that cannot read what was sent.
         */
        get: operations["queryStl"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/facets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * What the models are like, with counts
         * @description Classes, folders, kinds and units of files, and ranges of numbers, among the models that fit the filters;
         *     each list as if the filters did not ask for just that, so that another value can be chosen. Of more than
         *     1,000 values those of the most models.
         */
        get: operations["listFacets"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/models": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** List the models */
        get: operations["listModels"];
        put?: never;
        /**
         * Add a model to the collection
         * @description Queues the model for indexing and answers once it is safe on the disk; follow `Location` for the
         *     outcome, also after a restart of the server. A model that takes longer than `--model-timeout`
         *     fails with `cancelled`, one in whose middle the server ended three times with
         *     `upload_abandoned`. A model
         *     whose contents are already in the collection is not added twice: the job names the model that is
         *     there.
         */
        post: operations["addModel"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/models/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        /** One model */
        get: operations["getModel"];
        put?: never;
        post?: never;
        /**
         * Remove a model from the collection
         * @description The file that the model was read from is not touched.
         */
        delete: operations["removeModel"];
        options?: never;
        head?: never;
        /**
         * Change a model's class, or say which axis of it points up
         * @description One of the parameters at least. For `up` the model's picture is drawn anew from its preview mesh; nothing that
         *     is searched changes.
         */
        patch: operations["changeModel"];
        trace?: never;
    };
    "/v1/models/{id}/similar": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        /**
         * Rank the collection against one of its models
         * @description The model itself is not among the hits.
         */
        get: operations["similarModels"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/models/{id}/mesh": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        /** The model's preview mesh, at most 2,000 triangles */
        get: operations["modelMesh"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/models/{id}/skeleton": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        /** The model's refined skeleton with its chain codes */
        get: operations["modelSkeleton"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/models/{id}/segments": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        /**
         * The model's parts
         * @description The parts that people would see, as labels of the triangles of `/mesh`. They are those of
         *     the whole model, found when it was indexed: number, areas and neighbours are the whole
         *     mesh's. `segments_not_available` where it could not be cut, with the reason.
         */
        get: operations["modelSegments"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/models/{id}/rig.glb": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        /**
         * The model with joints to move it by
         * @description A binary glTF 2.0 file of the mesh of `/mesh`, a primitive and a colour for each part of
         *     `/segments`, skinned by the skeleton of `/skeleton`: a joint `branch N` for each branch, where it
         *     leaves the side of the thickest node (`root`), and a `tip of branch N` at each end; `extras.branch` of a
         *     joint and `extras.part` of a material are their numbers. Computed when
         *     asked for; `segments_not_available` where the model has no `/segments`. With `detail=full` made of the model's
         *     file instead, at its own resolution, where `/file` can be had.
         */
        get: operations["modelRig"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/models/{id}/file": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        /**
         * The file that the model was read from
         * @description Only of servers that are told so (`--serve-files`), and while the file is what was indexed; otherwise
         *     `original_not_available`. Of a model within an archive its own file.
         */
        get: operations["modelFile"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/models/{id}/mesh.stl": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        /**
         * The model as binary STL
         * @description All triangles of its file, see `/file`.
         */
        get: operations["modelStl"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/models/{id}/thumbnail.png": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        /**
         * A picture of the model
         * @description Under the address of the model's `links`, which has its version, caches may keep it for ever.
         */
        get: operations["modelThumbnail"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/compare": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The distance of two models, its parts, and what matches what */
        get: operations["compareModels"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/evaluations": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The evaluations that are at hand for the collection as it is */
        get: operations["listEvaluations"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/evaluations/{ranker}": {
        parameters: {
            query?: {
                /** @description Whether to re-rank by what the models of the collection have in common with each other. */
                rerank?: components["parameters"]["Rerank"];
            };
            header?: never;
            path: {
                ranker: components["parameters"]["RankerInPath"];
            };
            cookie?: never;
        };
        /**
         * Retrieval quality of one ranker over the collection's classes
         * @description Leave-one-out over the models whose class has at least two members, as in the Princeton Shape
         *     Benchmark. Computed on the first request and kept until the collection changes. Of large
         *     collections (`--max-evaluation-models`) a sample of the models, always the same one, searches in
         *     all of them: `models` is then less than `queries_total`, and `intervals` say how well it tells.
         *     There is none (404 `evaluation_not_found`) where fewer than two classes have two models.
         */
        get: operations["getEvaluation"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/evaluations/{ranker}.csv": {
        parameters: {
            query?: {
                /** @description Whether to re-rank by what the models of the collection have in common with each other. */
                rerank?: components["parameters"]["Rerank"];
            };
            header?: never;
            path: {
                ranker: components["parameters"]["RankerInPath"];
            };
            cookie?: never;
        };
        /** The precision-recall curve as a table */
        get: operations["getEvaluationTable"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/evaluations/{ranker}.svg": {
        parameters: {
            query?: {
                /** @description Whether to re-rank by what the models of the collection have in common with each other. */
                rerank?: components["parameters"]["Rerank"];
            };
            header?: never;
            path: {
                ranker: components["parameters"]["RankerInPath"];
            };
            cookie?: never;
        };
        /** The precision-recall curve as a picture */
        get: operations["getEvaluationPlot"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/failures": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Files that could not be indexed
         * @description Each with the stable code of what was wrong with it when it was last tried.
         */
        get: operations["listFailures"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * What was added, whoever did it
         * @description The last jobs, the newest first, also those that were accepted by other servers of this index or before this
         *     one was started.
         */
        get: operations["listJobs"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The job's number. */
                id: components["schemas"]["Id"];
            };
            cookie?: never;
        };
        /**
         * How far an added model has come
         * @description Jobs are kept in the index: one that was accepted is done after a restart too, and its outcome
         *     is told until a thousand later ones have finished. Numbers are never given twice.
         */
        get: operations["getJob"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/livez": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Whether the process answers */
        get: operations["live"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/readyz": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Whether the server can answer searches */
        get: operations["ready"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/metrics": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Metrics in the Prometheus text format */
        get: operations["metrics"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/openapi.yaml": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** This description */
        get: operations["describe"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/{file}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Empty for the start page, or the path of one of the gallery's files. */
                file: string;
            };
            cookie?: never;
        };
        /** The gallery's pages and files */
        get: operations["gallery"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
}
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        /** Format: int64 */
        Id: number;
        Token: string;
        /**
         * @description Below the folder that was indexed; empty for a model that was uploaded.
         * @example animals/elephant.off
         */
        Path: string;
        /** @enum {string} */
        Ranker: "hybrid" | "skeleton" | "chain-code";
        Vector: [
            number,
            number,
            number
        ];
        Bounds: {
            min: components["schemas"]["Vector"];
            max: components["schemas"]["Vector"];
        };
        /** @description Something odd about a mesh that does not keep it from being used. */
        Warning: {
            code: string;
            count: number;
            message: string;
        };
        Model: {
            id: components["schemas"]["Id"];
            /** @example elephant */
            name: string;
            /** @example fourleg */
            class: string | null;
            path: components["schemas"]["Path"];
            content_hash: string;
            vertices: number;
            /** @description Polygons in the file. */
            faces: number;
            /** @description Of the skeleton. */
            nodes: number;
            /** @description Of the skeleton. */
            branches: number;
            bounds: components["schemas"]["Bounds"];
            surface_area: number;
            unit: components["schemas"]["Unit"];
            metres_per_unit: components["schemas"]["MetresPerUnit"];
            /**
             * @description The axis of the model's coordinates that points up: as a person has said, else as its file or the
             *     file's format says, else as found from its shape. Viewers turn `mesh` and `skeleton` by it; the
             *     thumbnail is drawn so.
             * @enum {string}
             */
            up: "x" | "y" | "z";
            /**
             * @description Who says so.
             * @enum {string}
             */
            up_from: "person" | "file" | "shape";
            /** Format: date-time */
            indexed_at: string;
            warnings: components["schemas"]["Warning"][];
            links: {
                mesh: string;
                skeleton: string;
                segments: string;
                rig: string;
                similar: string;
                thumbnail: string;
                /** @description Where the server gives the files themselves. */
                file?: string;
                /** @description Likewise. */
                stl?: string;
                /** @description Shows the model within pages that may (`--allow-embedding`). */
                embed?: string;
            };
        };
        FacetValues: {
            /** @description Null for models without one. */
            value: string | null;
            models: number;
        }[];
        Facets: {
            classes: components["schemas"]["FacetValues"];
            folders: components["schemas"]["FacetValues"];
            kinds: components["schemas"]["FacetValues"];
            branches: components["schemas"]["FacetValues"];
            loops?: components["schemas"]["FacetValues"];
            extents: components["schemas"]["FacetValues"];
            units: components["schemas"]["FacetValues"];
            revision: number;
        };
        Query: {
            token: components["schemas"]["Token"];
            name: string;
            vertices: number;
            faces: number;
            bounds: components["schemas"]["Bounds"];
            warnings: components["schemas"]["Warning"][];
            links: {
                similar: string;
                mesh: string;
                skeleton: string;
                segments: string;
                rig: string;
                stl: string;
            };
        };
        ModelPage: {
            models: components["schemas"]["Model"][];
            /** @description Null on the last page. */
            next_cursor: string | null;
            /** @description Models that fit the filters, on all pages. */
            total: number;
            /** @description Grows whenever the collection changes. */
            revision: number;
        };
        /**
         * @description The unit of length of the file's coordinates, by its own word or its format's: `um`, `mm`, `cm`, `m`,
         *     `km`, `inch`, `foot`, `yard`, or a length such as `0.3 m`. Null where neither names one, and for models
         *     that were indexed before it was kept.
         * @example mm
         */
        Unit: string | null;
        /** @description The length of that unit. */
        MetresPerUnit: number | null;
        /** @description The colours of the file; null where it has none. */
        MeshColours: {
            /**
             * @description What they are the colours of: all of it; the vertices, between which they run evenly; the
             *     triangles; the corners of each triangle, three each.
             * @enum {string}
             */
            of: "model" | "vertices" | "triangles" | "corners";
            /** @description Red, green and blue of each, sRGB. */
            values: number[];
        } | null;
        Mesh: {
            /** @description From where `positions` are counted, in the file's frame: near the middle of the model, so that single precision is enough for the positions of models that lie far from the file's origin. */
            origin: components["schemas"]["Vector"];
            /** @description x, y, z of each vertex, from `origin`. */
            positions: number[];
            /** @description Three vertex indices each. */
            triangles: number[];
            colours: components["schemas"]["MeshColours"];
            bounds: components["schemas"]["Bounds"];
        };
        Skeleton: {
            /** @constant */
            unit: "model";
            nodes: {
                id: number;
                position: components["schemas"]["Vector"];
                /** @description Of the largest inscribed ball. */
                radius: number;
                degree: number;
                significance: number;
            }[];
            branches: {
                id: number;
                /** @description Node where the branch starts. */
                a: number;
                /** @description Node where it ends. */
                b: number;
                length: number;
                points: components["schemas"]["Vector"][];
                /** @description One for each point. */
                radii: number[];
                chain_code: string;
            }[];
        };
        Segments: {
            parts: {
                part: number;
                /** @description To show it in, #rrggbb. */
                colour: string;
                /** @description Of `/mesh`. */
                triangles: number;
                /** @description Of the whole model, in model units squared. */
                area: number;
                area_share: number;
                /** @description Of `/skeleton` that most of it belongs to. */
                branch: number | null;
                /** @description Parts that share a border with it. */
                neighbors: number[];
            }[];
            /** @description The part of each triangle of `/mesh`. */
            labels: number[];
        };
        /** @description What belongs together; `a` is the query's or first model's, `b` the hit's or second's. */
        Match: {
            nodes: components["schemas"]["Pair"][];
            branches: components["schemas"]["Pair"][];
            /** @description Sizes of the connected groups of matched nodes, largest first. */
            cluster_sizes: number[];
        };
        Pair: {
            a: number;
            b: number;
            cost: number;
        };
        /** @description Named shares of the distance. */
        Parts: {
            [key: string]: number;
        };
        /** @description How unlike the two are built, whatever their limbs do: 0 the same, 1 as two models usually are. Null for `chain-code` and for parts. */
        BuildDifference: number | null;
        /** @description How differently the two stand, whatever they are: 0 the same, 1 as two models usually do. Null for `chain-code` and for parts. */
        PoseDifference: number | null;
        Hit: {
            rank: number;
            id: components["schemas"]["Id"];
            name: string;
            class: string | null;
            path: components["schemas"]["Path"];
            /** @description Polygons in the file. */
            faces: number;
            /** @description Of its bounds, in model units. */
            extent: components["schemas"]["Vector"];
            /** @description How many models of the collection are copies of it. */
            copies: number;
            /** @description Where its picture is. */
            thumbnail: string;
            distance: number;
            parts: components["schemas"]["Parts"];
            build_difference: components["schemas"]["BuildDifference"];
            pose_difference: components["schemas"]["PoseDifference"];
            /** @description Matched pairs of nodes. */
            matched_nodes: number;
            /** @description Where a part lies in the hit; null without `part`, and where no place was looked for or found. */
            placement: {
                /**
                 * @description Rows of the 4 x 4 matrix that takes points of the query (its file's coordinates, as columns)
                 *     to points of the hit.
                 */
                matrix: number[][];
                /** @description How much larger the part is in the hit. */
                scale: number;
                /** @description Share of the part's area that lies on the hit and faces its way. */
                explained: number;
            } | null;
            match: components["schemas"]["Match"];
        };
        SearchResult: {
            took_ms: number;
            /** @description Milliseconds by stage of the pipeline. */
            stages_ms: {
                [key: string]: number;
            };
            ranker: components["schemas"]["Ranker"];
            pose: number;
            size: number;
            rerank: boolean;
            part: boolean;
            /** @description Models in the collection that was searched. */
            models: number;
            /** @description Of the collection that was searched. */
            revision?: number;
            query: {
                name: string;
                vertices: number;
                faces: number;
                unit: components["schemas"]["Unit"];
                metres_per_unit: components["schemas"]["MetresPerUnit"];
                /**
                 * @description The axis that the query's file says points up; with `include=mesh` also one that was found
                 *     from its shape. Missing where neither is known, and for queries that are indexed models.
                 * @enum {string}
                 */
                up?: "x" | "y" | "z";
                warnings: components["schemas"]["Warning"][];
                skeleton: components["schemas"]["Skeleton"];
                /** @description With `include=mesh` only. */
                mesh?: components["schemas"]["Mesh"];
            };
            /** @description Of an upload, where it is kept; null where it is not. */
            token?: string | null;
            hits: components["schemas"]["Hit"][];
        };
        Comparison: {
            a: components["schemas"]["Model"];
            b: components["schemas"]["Model"];
            ranker: components["schemas"]["Ranker"];
            pose?: number;
            part: boolean;
            distance: number;
            parts: components["schemas"]["Parts"];
            build_difference: components["schemas"]["BuildDifference"];
            pose_difference: components["schemas"]["PoseDifference"];
            matched_nodes: number;
            match: components["schemas"]["Match"];
            skeletons: {
                a: components["schemas"]["Skeleton"];
                b: components["schemas"]["Skeleton"];
            };
        };
        EvaluationList: {
            evaluations: {
                ranker: components["schemas"]["Ranker"];
                rerank: boolean;
                models: number;
                classes: number;
                /**
                 * Format: date-time
                 * @description Null until it has been asked for.
                 */
                computed_at: string | null;
                links: {
                    json: string;
                    csv: string;
                    svg: string;
                };
            }[];
        };
        /** @description The Princeton Shape Benchmark's measures, each from 0 to 1. */
        Metrics: {
            nearest_neighbor: number;
            first_tier: number;
            second_tier: number;
            e_measure: number;
            dcg: number;
            mean_average_precision: number;
        };
        Interval: {
            low: number;
            high: number;
        };
        QueryMetrics: components["schemas"]["Metrics"] & {
            model: components["schemas"]["Id"];
            name: string;
            class: string;
        };
        FailureList: {
            failures: {
                path: components["schemas"]["Path"];
                content_hash: string | null;
                /** @description Stable. */
                code: string;
                message: string;
                /** Format: date-time */
                failed_at: string;
            }[];
        };
        Evaluation: components["schemas"]["Metrics"] & {
            /** @description That were searched with. */
            models: number;
            /** @description That they are of. */
            classes: number;
            /** @description Models that could be searched with; more than `models` where a sample was. */
            queries_total: number;
            /** @description Where each measure would lie for other queries of the same kind, 95 times in 100 (bootstrap over queries). */
            intervals: {
                nearest_neighbor: components["schemas"]["Interval"];
                first_tier: components["schemas"]["Interval"];
                second_tier: components["schemas"]["Interval"];
                e_measure: components["schemas"]["Interval"];
                dcg: components["schemas"]["Interval"];
                mean_average_precision: components["schemas"]["Interval"];
            };
            /** @description With `include=queries` only. */
            queries?: components["schemas"]["QueryMetrics"][];
            ranker: components["schemas"]["Ranker"];
            rerank: boolean;
            pose?: number;
            /** @description Of the collection that was evaluated. */
            revision?: number;
            /** Format: date-time */
            computed_at?: string;
            /** @description Models that the classification names and the collection does not hold. */
            missing?: string[];
            /** @description Means over classes, each class with the same weight. */
            macro_mean?: components["schemas"]["Metrics"];
            precision_recall: {
                recall: number;
                precision: number;
            }[];
            per_class: {
                [key: string]: components["schemas"]["Metrics"] & {
                    models: number;
                };
            };
            confusion: {
                classes: string[];
                /** @description Row i, column j is the share of class i whose nearest neighbour is of class j. */
                values: number[][];
            };
        };
        Job: {
            id: components["schemas"]["Id"];
            /** @enum {string} */
            state: "queued" | "running" | "done" | "failed";
            /** @description The model's id once it is in the collection. */
            model: number | null;
            error: {
                code: string;
                message: string;
            } | null;
        };
        Jobs: {
            jobs: (components["schemas"]["Job"] & {
                name: string;
                class: string | null;
                /** @description Bytes of the file. */
                size: number;
                /** Format: date-time */
                accepted_at: string;
                /** Format: date-time */
                finished_at: string | null;
            })[];
        };
        Progress: {
            /**
             * @description `wait` until there is room for it; `read`; one of those that `stages_ms` of its answer has. Null where no
             *     search runs under the token: not yet, or not any more.
             */
            stage: string | null;
        };
        Health: {
            /** @constant */
            status: "ok";
        };
        /** @description RFC 9457. */
        Problem: {
            /** @constant */
            type: "about:blank";
            title: string;
            status: number;
            /** @example line 3: expected 3 numbers, found 2 */
            detail: string;
            code: components["schemas"]["ProblemCode"];
            /** @description The path that was asked for. */
            instance: string;
            request_id: string;
            /** @description The parameter that is wrong, where one is. */
            parameter?: string;
        };
        /**
         * @description Stable; new ones may be added.
         * @enum {string}
         */
        ProblemCode: "invalid_argument" | "cancelled" | "internal" | "out_of_memory" | "file_not_found" | "file_unreadable" | "file_unwritable" | "file_too_large" | "format_unsupported" | "format_unknown" | "off_header" | "off_binary" | "off_dimension" | "off_counts" | "off_too_many_vertices" | "off_too_many_faces" | "off_too_many_corners" | "off_truncated" | "off_bad_number" | "off_non_finite" | "off_index_out_of_range" | "off_line_too_long" | "stl_syntax" | "stl_too_many_vertices" | "stl_too_many_faces" | "stl_too_many_corners" | "stl_truncated" | "stl_bad_number" | "stl_non_finite" | "obj_binary" | "obj_too_many_vertices" | "obj_too_many_faces" | "obj_too_many_corners" | "obj_truncated" | "obj_bad_number" | "obj_non_finite" | "obj_index_out_of_range" | "ply_header" | "ply_too_many_vertices" | "ply_too_many_faces" | "ply_too_many_corners" | "ply_truncated" | "ply_bad_number" | "ply_non_finite" | "ply_index_out_of_range" | "xyz_too_many_points" | "xyz_truncated" | "xyz_bad_number" | "xyz_non_finite" | "three_mf_invalid" | "three_mf_extension" | "gltf_invalid" | "gltf_extension" | "gltf_buffer" | "scene_invalid" | "model_too_many_vertices" | "model_too_many_faces" | "model_too_many_corners" | "model_non_finite" | "reader_time" | "reader_memory" | "reader_crashed" | "reader_unavailable" | "mesh_empty" | "mesh_no_extent" | "solid_empty" | "npy_invalid" | "nrrd_invalid" | "nifti_invalid" | "binvox_invalid" | "volume_detached" | "gzip_invalid" | "archive_invalid" | "archive_member" | "archive_several" | "archive_empty" | "object_missing" | "volume_too_large" | "mesh_scale" | "points_too_few" | "cla_invalid" | "cla_unknown_model" | "seg_invalid" | "index_not_found" | "index_foreign" | "index_newer" | "index_corrupt" | "index_busy" | "index_io" | "index_parameters" | "model_not_found" | "evaluation_not_found" | "index_replaced" | "upload_abandoned" | "prune_refused" | "malformed_request" | "control_characters" | "bad_escape" | "ambiguous_length" | "body_unexpected" | "body_incomplete" | "body_empty" | "multipart_invalid" | "parameter_unknown" | "parameter_repeated" | "parameter_missing" | "parameter_invalid" | "admin_key_missing" | "admin_key_wrong" | "read_key_missing" | "read_key_wrong" | "admin_disabled" | "cross_site_request" | "route_not_found" | "file_not_served" | "job_not_found" | "query_not_found" | "original_not_available" | "segments_not_available" | "thumbnail_not_available" | "method_not_allowed" | "request_timeout" | "length_required" | "payload_too_large" | "uri_too_long" | "media_type_unsupported" | "content_encoding_unsupported" | "expectation_failed" | "host_not_served" | "too_many_fields" | "fields_too_large" | "method_unknown" | "version_unsupported" | "overloaded" | "search_timeout" | "shutting_down";
    };
    responses: {
        /** @description What `If-None-Match` names is still true. */
        NotModified: {
            headers: {
                ETag: components["headers"]["ETag"];
                [name: string]: unknown;
            };
            content?: never;
        };
        /**
         * @description The request is malformed, or a parameter is unknown, repeated or out of range
         *     (`parameter_unknown`, `parameter_repeated`, `parameter_missing`, `parameter_invalid`).
         */
        BadRequest: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The administrator's key is missing (`admin_key_missing`) or wrong (`admin_key_wrong`). */
        Unauthorized: {
            headers: {
                "WWW-Authenticate"?: "Bearer realm=\"ossuary\"";
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /**
         * @description The server has no administrator's key (`admin_disabled`), or another site's page sent the request
         *     (`cross_site_request`).
         */
        Forbidden: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /**
         * @description `route_not_found`, `model_not_found`, `job_not_found`, `evaluation_not_found`,
         *     `segments_not_available`, `thumbnail_not_available` or `file_not_served`.
         */
        NotFound: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The request did not arrive in time (`request_timeout`). */
        RequestTimeout: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description A body needs a `Content-Length` and no `Transfer-Encoding` (`length_required`). */
        LengthRequired: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /**
         * @description The body is longer than the server takes (`payload_too_large`), or the model has more vertices,
         *     faces or corners than it takes (`off_too_many_vertices`, `model_too_many_faces`, …).
         */
        TooLarge: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /**
         * @description The content type (`media_type_unsupported`), a content encoding (`content_encoding_unsupported`)
         *     or the model's format (`format_unknown`, `format_unsupported`).
         */
        UnsupportedMediaType: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /**
         * @description The model cannot be read or has no skeleton; `detail` names the line, the byte or the triangle,
         *     and what was expected (`off_truncated`, `ply_header`, `obj_index_out_of_range`, `gltf_invalid`,
         *     `mesh_empty`, …). `reader_time`, `reader_memory` and `reader_crashed` say that the process that read
         *     the file had to be ended, or was by the file. A glTF document must hold its buffers: the server gives
         *     it no others (`gltf_buffer`), unless they come with it in a ZIP archive, which holds one model
         *     (`archive_several`, `archive_empty`, `archive_invalid`).
         */
        UnusableModel: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /**
         * @description Too much to do (`overloaded`), out of time (`search_timeout`), the index is busy (`index_busy`), or the
         *     server is shutting down (`shutting_down`). `Retry-After` says when to come back.
         */
        Unavailable: {
            headers: {
                /** @description Seconds. */
                "Retry-After"?: number;
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
    };
    parameters: {
        /** @description The model's id. */
        ModelId: components["schemas"]["Id"];
        /** @description The most hits to answer with. */
        Limit: number;
        /** @description How distances are measured. */
        Ranker: components["schemas"]["Ranker"];
        RankerInPath: components["schemas"]["Ranker"];
        /** @description From 0 (how a model is built alone, whatever its limbs do) to 1 (how it stands alone, whatever it is). The default tells kinds apart best. `chain-code` and parts take no notice of it. */
        Pose: number;
        /** @description How far the size counts, for models that are all in one unit, from 0 (not at all) to 1. `chain-code` and parts take no notice of it. */
        Size: number;
        /** @description Only models of this class. */
        Class: string;
        /** @description Only models whose name contains this text; ASCII letters match in either case. */
        NameContains: string;
        /** @description Only models whose `path` lies in this folder or further down. */
        Folder: string;
        /** @description Only models of files with this ending, in small letters. */
        Kind: string;
        /** @description Only models whose skeleton has so many branches, `5-8` from 5 up to and with 8. */
        Branches: "0" | "1-4" | "5-8" | "9-16" | "17-32" | "33-64" | "65-128" | "129-";
        /** @description Only models whose skeleton has so many independent loops. */
        Loops: "0" | "1" | "2" | "3-4" | "5-8" | "9-16" | "17-";
        /**
         * @description Only models whose longest side is from the first number up to but without the second: `10-100mm` those whose
         *     unit is known, `10-100` the others in the files' own numbers. The ranges are those of the facet `extents`:
         *     tens from 0.001 to 1000000.
         */
        Extent: string;
        /** @description Only models of files in this unit. */
        Unit: string;
        /** @description The `token` of a search's answer. */
        QueryToken: components["schemas"]["Token"];
        /** @description `full` for the model at its own resolution instead of its preview's. */
        Detail: "full";
        /** @description What to call the query; the file name of the multipart field, else `upload`, when absent. */
        Name: string;
        /** @description Whether to re-rank by what the models of the collection have in common with each other. */
        Rerank: boolean;
        /**
         * @description Whether the query (of a comparison: `a`) is looked for as a part of the other model: an arm finds
         *     people. Models are put in order by local features of their surfaces and by skeletons, in the most
         *     alike the part is laid where it fits best (`placement` of the hit), and what lies in its place
         *     comes first. Comparisons go by skeletons alone. The `ranker` is then of no consequence, and
         *     `rerank` is refused. A part is smaller than the whole by an unknown factor, and what the whole has
         *     besides is free. The query's warning `features_missing` counts models whose surface is not known.
         */
        Part: boolean;
        /**
         * @description Of a volume (NRRD, NIfTI, binvox, .npy): values of at least this are the model. Found from the values when
         *     neither this nor `label` is given; other files have no use for it. Refused beside `label`.
         */
        Threshold: number;
        /** @description Of a volume: this value alone is the model. A label that no voxel has is refused (`solid_empty`). */
        Label: number;
        /**
         * @description Whether of models that are copies of each other the nearest alone is a hit; its `copies` says how many there
         *     are besides. Copies have meshes that measure the same to the last bit.
         */
        Fold: boolean;
    };
    requestBodies: {
        /** @description A model file with a `Content-Length`. Chunked and compressed bodies are refused (411, 415). */
        Model: {
            content: {
                "application/octet-stream": unknown;
                "text/plain": unknown;
                "model/*": unknown;
                "text/prs.wavefront-obj": unknown;
                "application/vnd.ms-pki.stl": unknown;
                "application/sla": unknown;
                "application/vnd.ms-package.3dmanufacturing-3dmodel+xml": unknown;
                "application/gzip": unknown;
                "application/x-gzip": unknown;
                "application/zip": unknown;
                "application/x-zip-compressed": unknown;
                "multipart/form-data": {
                    model: string;
                };
            };
        };
    };
    headers: {
        /**
         * @description Names this request in the server's log. The request's own `X-Request-Id` if that is 1 to 64
         *     letters, digits, `.`, `_` or `-`.
         */
        RequestId: string;
        /** @description Send it as `If-None-Match` to get 304 while nothing has changed. */
        ETag: string;
    };
    pathItems: never;
}
export type Id = components['schemas']['Id'];
export type Token = components['schemas']['Token'];
export type Path = components['schemas']['Path'];
export type Ranker = components['schemas']['Ranker'];
export type Vector = components['schemas']['Vector'];
export type Bounds = components['schemas']['Bounds'];
export type Warning = components['schemas']['Warning'];
export type Model = components['schemas']['Model'];
export type FacetValues = components['schemas']['FacetValues'];
export type Facets = components['schemas']['Facets'];
export type Query = components['schemas']['Query'];
export type ModelPage = components['schemas']['ModelPage'];
export type Unit = components['schemas']['Unit'];
export type MetresPerUnit = components['schemas']['MetresPerUnit'];
export type MeshColours = components['schemas']['MeshColours'];
export type Mesh = components['schemas']['Mesh'];
export type Skeleton = components['schemas']['Skeleton'];
export type Segments = components['schemas']['Segments'];
export type Match = components['schemas']['Match'];
export type Pair = components['schemas']['Pair'];
export type Parts = components['schemas']['Parts'];
export type BuildDifference = components['schemas']['BuildDifference'];
export type PoseDifference = components['schemas']['PoseDifference'];
export type Hit = components['schemas']['Hit'];
export type SearchResult = components['schemas']['SearchResult'];
export type Comparison = components['schemas']['Comparison'];
export type EvaluationList = components['schemas']['EvaluationList'];
export type Metrics = components['schemas']['Metrics'];
export type Interval = components['schemas']['Interval'];
export type QueryMetrics = components['schemas']['QueryMetrics'];
export type FailureList = components['schemas']['FailureList'];
export type Evaluation = components['schemas']['Evaluation'];
export type Job = components['schemas']['Job'];
export type Jobs = components['schemas']['Jobs'];
export type Progress = components['schemas']['Progress'];
export type Health = components['schemas']['Health'];
export type Problem = components['schemas']['Problem'];
export type ProblemCode = components['schemas']['ProblemCode'];
export type ResponseNotModified = components['responses']['NotModified'];
export type ResponseBadRequest = components['responses']['BadRequest'];
export type ResponseUnauthorized = components['responses']['Unauthorized'];
export type ResponseForbidden = components['responses']['Forbidden'];
export type ResponseNotFound = components['responses']['NotFound'];
export type ResponseRequestTimeout = components['responses']['RequestTimeout'];
export type ResponseLengthRequired = components['responses']['LengthRequired'];
export type ResponseTooLarge = components['responses']['TooLarge'];
export type ResponseUnsupportedMediaType = components['responses']['UnsupportedMediaType'];
export type ResponseUnusableModel = components['responses']['UnusableModel'];
export type ResponseUnavailable = components['responses']['Unavailable'];
export type ParameterModelId = components['parameters']['ModelId'];
export type ParameterLimit = components['parameters']['Limit'];
export type ParameterRanker = components['parameters']['Ranker'];
export type ParameterRankerInPath = components['parameters']['RankerInPath'];
export type ParameterPose = components['parameters']['Pose'];
export type ParameterSize = components['parameters']['Size'];
export type ParameterClass = components['parameters']['Class'];
export type ParameterNameContains = components['parameters']['NameContains'];
export type ParameterFolder = components['parameters']['Folder'];
export type ParameterKind = components['parameters']['Kind'];
export type ParameterBranches = components['parameters']['Branches'];
export type ParameterLoops = components['parameters']['Loops'];
export type ParameterExtent = components['parameters']['Extent'];
export type ParameterUnit = components['parameters']['Unit'];
export type ParameterQueryToken = components['parameters']['QueryToken'];
export type ParameterDetail = components['parameters']['Detail'];
export type ParameterName = components['parameters']['Name'];
export type ParameterRerank = components['parameters']['Rerank'];
export type ParameterPart = components['parameters']['Part'];
export type ParameterThreshold = components['parameters']['Threshold'];
export type ParameterLabel = components['parameters']['Label'];
export type ParameterFold = components['parameters']['Fold'];
export type RequestBodyModel = components['requestBodies']['Model'];
export type HeaderRequestId = components['headers']['RequestId'];
export type HeaderETag = components['headers']['ETag'];
export type $defs = Record<string, never>;
export interface operations {
    search: {
        parameters: {
            query?: {
                /** @description The most hits to answer with. */
                limit?: components["parameters"]["Limit"];
                /** @description How distances are measured. */
                ranker?: components["parameters"]["Ranker"];
                /** @description From 0 (how a model is built alone, whatever its limbs do) to 1 (how it stands alone, whatever it is). The default tells kinds apart best. `chain-code` and parts take no notice of it. */
                pose?: components["parameters"]["Pose"];
                /** @description How far the size counts, for models that are all in one unit, from 0 (not at all) to 1. `chain-code` and parts take no notice of it. */
                size?: components["parameters"]["Size"];
                /** @description Only models of this class. */
                class?: components["parameters"]["Class"];
                /** @description Only models whose `path` lies in this folder or further down. */
                folder?: components["parameters"]["Folder"];
                /** @description Only models of files with this ending, in small letters. */
                kind?: components["parameters"]["Kind"];
                /** @description Whether to re-rank by what the models of the collection have in common with each other. */
                rerank?: components["parameters"]["Rerank"];
                /**
                 * @description Whether the query (of a comparison: `a`) is looked for as a part of the other model: an arm finds
                 *     people. Models are put in order by local features of their surfaces and by skeletons, in the most
                 *     alike the part is laid where it fits best (`placement` of the hit), and what lies in its place
                 *     comes first. Comparisons go by skeletons alone. The `ranker` is then of no consequence, and
                 *     `rerank` is refused. A part is smaller than the whole by an unknown factor, and what the whole has
                 *     besides is free. The query's warning `features_missing` counts models whose surface is not known.
                 */
                part?: components["parameters"]["Part"];
                /**
                 * @description Of a volume (NRRD, NIfTI, binvox, .npy): values of at least this are the model. Found from the values when
                 *     neither this nor `label` is given; other files have no use for it. Refused beside `label`.
                 */
                threshold?: components["parameters"]["Threshold"];
                /** @description Of a volume: this value alone is the model. A label that no voxel has is refused (`solid_empty`). */
                label?: components["parameters"]["Label"];
                /**
                 * @description Whether of models that are copies of each other the nearest alone is a hit; its `copies` says how many there
                 *     are besides. Copies have meshes that measure the same to the last bit.
                 */
                fold?: components["parameters"]["Fold"];
                /** @description `mesh` adds a preview mesh of the query to the answer. */
                include?: "mesh";
                /** @description What to call the query; the file name of the multipart field, else `upload`, when absent. */
                name?: components["parameters"]["Name"];
                /**
                 * @description A random number of 128 bits that the client makes up: while the search runs, `/v1/progress/{token}` tells
                 *     its stage under it.
                 */
                progress?: components["schemas"]["Token"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: components["requestBodies"]["Model"];
        responses: {
            /** @description The ranked list, best first. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SearchResult"];
                };
            };
            400: components["responses"]["BadRequest"];
            403: components["responses"]["Forbidden"];
            408: components["responses"]["RequestTimeout"];
            411: components["responses"]["LengthRequired"];
            413: components["responses"]["TooLarge"];
            415: components["responses"]["UnsupportedMediaType"];
            422: components["responses"]["UnusableModel"];
            503: components["responses"]["Unavailable"];
        };
    };
    getProgress: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description What the search was given as `progress`. */
                token: components["schemas"]["Token"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The stage. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Progress"];
                };
            };
            400: components["responses"]["BadRequest"];
        };
    };
    getQuery: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The query. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Query"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
        };
    };
    similarToQuery: {
        parameters: {
            query?: {
                /** @description The most hits to answer with. */
                limit?: components["parameters"]["Limit"];
                /** @description How distances are measured. */
                ranker?: components["parameters"]["Ranker"];
                /** @description From 0 (how a model is built alone, whatever its limbs do) to 1 (how it stands alone, whatever it is). The default tells kinds apart best. `chain-code` and parts take no notice of it. */
                pose?: components["parameters"]["Pose"];
                /** @description How far the size counts, for models that are all in one unit, from 0 (not at all) to 1. `chain-code` and parts take no notice of it. */
                size?: components["parameters"]["Size"];
                /** @description Only models of this class. */
                class?: components["parameters"]["Class"];
                /** @description Only models whose `path` lies in this folder or further down. */
                folder?: components["parameters"]["Folder"];
                /** @description Only models of files with this ending, in small letters. */
                kind?: components["parameters"]["Kind"];
                /** @description Whether to re-rank by what the models of the collection have in common with each other. */
                rerank?: components["parameters"]["Rerank"];
                /**
                 * @description Whether the query (of a comparison: `a`) is looked for as a part of the other model: an arm finds
                 *     people. Models are put in order by local features of their surfaces and by skeletons, in the most
                 *     alike the part is laid where it fits best (`placement` of the hit), and what lies in its place
                 *     comes first. Comparisons go by skeletons alone. The `ranker` is then of no consequence, and
                 *     `rerank` is refused. A part is smaller than the whole by an unknown factor, and what the whole has
                 *     besides is free. The query's warning `features_missing` counts models whose surface is not known.
                 */
                part?: components["parameters"]["Part"];
                /**
                 * @description Whether of models that are copies of each other the nearest alone is a hit; its `copies` says how many there
                 *     are besides. Copies have meshes that measure the same to the last bit.
                 */
                fold?: components["parameters"]["Fold"];
            };
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The ranked list, best first. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SearchResult"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    queryMesh: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The mesh. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Mesh"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    querySkeleton: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The skeleton. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Skeleton"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
        };
    };
    querySegments: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The parts, by descending area. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Segments"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    queryRig: {
        parameters: {
            query?: {
                /** @description `full` for the model at its own resolution instead of its preview's. */
                detail?: components["parameters"]["Detail"];
            };
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The rigged model. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "model/gltf-binary": unknown;
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    queryStl: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The `token` of a search's answer. */
                token: components["parameters"]["QueryToken"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The mesh. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "model/stl": unknown;
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
        };
    };
    listFacets: {
        parameters: {
            query?: {
                /** @description Only models of this class. */
                class?: components["parameters"]["Class"];
                /** @description Only models whose name contains this text; ASCII letters match in either case. */
                name?: components["parameters"]["NameContains"];
                /** @description Only models whose `path` lies in this folder or further down. */
                folder?: components["parameters"]["Folder"];
                /** @description Only models of files with this ending, in small letters. */
                kind?: components["parameters"]["Kind"];
                /** @description Only models whose skeleton has so many branches, `5-8` from 5 up to and with 8. */
                branches?: components["parameters"]["Branches"];
                /** @description Only models whose skeleton has so many independent loops. */
                loops?: components["parameters"]["Loops"];
                /**
                 * @description Only models whose longest side is from the first number up to but without the second: `10-100mm` those whose
                 *     unit is known, `10-100` the others in the files' own numbers. The ranges are those of the facet `extents`:
                 *     tens from 0.001 to 1000000.
                 */
                extent?: components["parameters"]["Extent"];
                /** @description Only models of files in this unit. */
                unit?: components["parameters"]["Unit"];
                /**
                 * @description `loops` adds those, which are read of every skeleton when they are first asked for: in collections of a
                 *     hundred thousand models that takes longer than all else.
                 */
                include?: "loops";
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The counts. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Facets"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            503: components["responses"]["Unavailable"];
        };
    };
    listModels: {
        parameters: {
            query?: {
                /** @description Models a page. */
                limit?: number;
                /**
                 * @description The `next_cursor` of the page before; opaque, and valid only with the same filters, in the order of
                 *     ids and without `offset`. Models added or removed meanwhile neither shift nor repeat entries.
                 */
                cursor?: string;
                /** @description How many models of the list to pass over, to look anywhere into it. */
                offset?: number;
                /**
                 * @description By `id`; by `name` with numbers in it as numbers; or those first that were indexed last (`newest`) or
                 *     that have the most `faces` or `branches`.
                 */
                sort?: "id" | "name" | "newest" | "faces" | "branches";
                /** @description Only models of this class. */
                class?: components["parameters"]["Class"];
                /** @description Only models whose name contains this text; ASCII letters match in either case. */
                name?: components["parameters"]["NameContains"];
                /** @description Only models whose `path` lies in this folder or further down. */
                folder?: components["parameters"]["Folder"];
                /** @description Only models of files with this ending, in small letters. */
                kind?: components["parameters"]["Kind"];
                /** @description Only models whose skeleton has so many branches, `5-8` from 5 up to and with 8. */
                branches?: components["parameters"]["Branches"];
                /** @description Only models whose skeleton has so many independent loops. */
                loops?: components["parameters"]["Loops"];
                /**
                 * @description Only models whose longest side is from the first number up to but without the second: `10-100mm` those whose
                 *     unit is known, `10-100` the others in the files' own numbers. The ranges are those of the facet `extents`:
                 *     tens from 0.001 to 1000000.
                 */
                extent?: components["parameters"]["Extent"];
                /** @description Only models of files in this unit. */
                unit?: components["parameters"]["Unit"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description One page. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ModelPage"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            503: components["responses"]["Unavailable"];
        };
    };
    addModel: {
        parameters: {
            query?: {
                /** @description The model's name; the file name of the multipart field, else `upload`, when absent. */
                name?: string;
                /** @description The model's class, if it has one. */
                class?: string;
                /**
                 * @description Of a volume (NRRD, NIfTI, binvox, .npy): values of at least this are the model. Found from the values when
                 *     neither this nor `label` is given; other files have no use for it. Refused beside `label`.
                 */
                threshold?: components["parameters"]["Threshold"];
                /** @description Of a volume: this value alone is the model. A label that no voxel has is refused (`solid_empty`). */
                label?: components["parameters"]["Label"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: components["requestBodies"]["Model"];
        responses: {
            /** @description Queued. */
            202: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    /** @description Where to follow the job. */
                    Location?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        /** @example /v1/jobs/3 */
                        job: string;
                    };
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["Forbidden"];
            408: components["responses"]["RequestTimeout"];
            411: components["responses"]["LengthRequired"];
            413: components["responses"]["TooLarge"];
            415: components["responses"]["UnsupportedMediaType"];
            422: components["responses"]["UnusableModel"];
            503: components["responses"]["Unavailable"];
        };
    };
    getModel: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The model. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Model"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
        };
    };
    removeModel: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Removed. */
            204: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["Forbidden"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    changeModel: {
        parameters: {
            query?: {
                /** @description Its new class; empty for none. */
                class?: string;
                /** @description The axis, or `auto` for what its file says or else its shape suggests. */
                up?: "x" | "y" | "z" | "auto";
            };
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The model as it is now. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Model"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["Forbidden"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    similarModels: {
        parameters: {
            query?: {
                /** @description The most hits to answer with. */
                limit?: components["parameters"]["Limit"];
                /** @description How distances are measured. */
                ranker?: components["parameters"]["Ranker"];
                /** @description From 0 (how a model is built alone, whatever its limbs do) to 1 (how it stands alone, whatever it is). The default tells kinds apart best. `chain-code` and parts take no notice of it. */
                pose?: components["parameters"]["Pose"];
                /** @description How far the size counts, for models that are all in one unit, from 0 (not at all) to 1. `chain-code` and parts take no notice of it. */
                size?: components["parameters"]["Size"];
                /** @description Only models of this class. */
                class?: components["parameters"]["Class"];
                /** @description Only models whose `path` lies in this folder or further down. */
                folder?: components["parameters"]["Folder"];
                /** @description Only models of files with this ending, in small letters. */
                kind?: components["parameters"]["Kind"];
                /** @description Whether to re-rank by what the models of the collection have in common with each other. */
                rerank?: components["parameters"]["Rerank"];
                /**
                 * @description Whether the query (of a comparison: `a`) is looked for as a part of the other model: an arm finds
                 *     people. Models are put in order by local features of their surfaces and by skeletons, in the most
                 *     alike the part is laid where it fits best (`placement` of the hit), and what lies in its place
                 *     comes first. Comparisons go by skeletons alone. The `ranker` is then of no consequence, and
                 *     `rerank` is refused. A part is smaller than the whole by an unknown factor, and what the whole has
                 *     besides is free. The query's warning `features_missing` counts models whose surface is not known.
                 */
                part?: components["parameters"]["Part"];
                /**
                 * @description Whether of models that are copies of each other the nearest alone is a hit; its `copies` says how many there
                 *     are besides. Copies have meshes that measure the same to the last bit.
                 */
                fold?: components["parameters"]["Fold"];
            };
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The ranked list, best first. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SearchResult"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    modelMesh: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The mesh. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Mesh"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
        };
    };
    modelSkeleton: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The skeleton. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Skeleton"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
        };
    };
    modelSegments: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The parts, by descending area. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Segments"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    modelRig: {
        parameters: {
            query?: {
                /** @description `full` for the model at its own resolution instead of its preview's. */
                detail?: components["parameters"]["Detail"];
            };
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The rigged model. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "model/gltf-binary": unknown;
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    modelFile: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The file. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": unknown;
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    modelStl: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The mesh. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "model/stl": unknown;
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    modelThumbnail: {
        parameters: {
            query?: {
                /** @description The version. */
                v?: string;
            };
            header?: never;
            path: {
                /** @description The model's id. */
                id: components["parameters"]["ModelId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The picture. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "image/png": unknown;
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
        };
    };
    compareModels: {
        parameters: {
            query: {
                /** @description Id of the first model. */
                a: components["schemas"]["Id"];
                /** @description Id of the second model. */
                b: components["schemas"]["Id"];
                /** @description How distances are measured. */
                ranker?: components["parameters"]["Ranker"];
                /** @description From 0 (how a model is built alone, whatever its limbs do) to 1 (how it stands alone, whatever it is). The default tells kinds apart best. `chain-code` and parts take no notice of it. */
                pose?: components["parameters"]["Pose"];
                /** @description How far the size counts, for models that are all in one unit, from 0 (not at all) to 1. `chain-code` and parts take no notice of it. */
                size?: components["parameters"]["Size"];
                /**
                 * @description Whether the query (of a comparison: `a`) is looked for as a part of the other model: an arm finds
                 *     people. Models are put in order by local features of their surfaces and by skeletons, in the most
                 *     alike the part is laid where it fits best (`placement` of the hit), and what lies in its place
                 *     comes first. Comparisons go by skeletons alone. The `ranker` is then of no consequence, and
                 *     `rerank` is refused. A part is smaller than the whole by an unknown factor, and what the whole has
                 *     besides is free. The query's warning `features_missing` counts models whose surface is not known.
                 */
                part?: components["parameters"]["Part"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The comparison. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Comparison"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    listEvaluations: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The evaluations. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EvaluationList"];
                };
            };
            400: components["responses"]["BadRequest"];
            503: components["responses"]["Unavailable"];
        };
    };
    getEvaluation: {
        parameters: {
            query?: {
                /** @description Whether to re-rank by what the models of the collection have in common with each other. */
                rerank?: components["parameters"]["Rerank"];
                /** @description `queries` adds the measures of each query. */
                include?: "queries";
            };
            header?: never;
            path: {
                ranker: components["parameters"]["RankerInPath"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The evaluation. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Evaluation"];
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    getEvaluationTable: {
        parameters: {
            query?: {
                /** @description Whether to re-rank by what the models of the collection have in common with each other. */
                rerank?: components["parameters"]["Rerank"];
            };
            header?: never;
            path: {
                ranker: components["parameters"]["RankerInPath"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Comma-separated values with the header line `recall,precision`. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "text/csv": string;
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    getEvaluationPlot: {
        parameters: {
            query?: {
                /** @description Whether to re-rank by what the models of the collection have in common with each other. */
                rerank?: components["parameters"]["Rerank"];
            };
            header?: never;
            path: {
                ranker: components["parameters"]["RankerInPath"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The plot. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "image/svg+xml": string;
                };
            };
            304: components["responses"]["NotModified"];
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
            503: components["responses"]["Unavailable"];
        };
    };
    listFailures: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The failures, by path. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FailureList"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["Forbidden"];
            503: components["responses"]["Unavailable"];
        };
    };
    listJobs: {
        parameters: {
            query?: {
                /** @description Jobs at most. */
                limit?: number;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The jobs. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Jobs"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["Forbidden"];
        };
    };
    getJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description The job's number. */
                id: components["schemas"]["Id"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The job. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["BadRequest"];
            404: components["responses"]["NotFound"];
        };
    };
    live: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It does. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Health"];
                };
            };
        };
    };
    ready: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The index is open and the server is not shutting down. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Health"];
                };
            };
            503: components["responses"]["Unavailable"];
        };
    };
    metrics: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The metrics; docs/operations.md lists them. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
        };
    };
    describe: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description OpenAPI 3.1. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/yaml": string;
                };
            };
            304: components["responses"]["NotModified"];
        };
    };
    gallery: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Empty for the start page, or the path of one of the gallery's files. */
                file: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The file, with its content type. */
            200: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "text/html": unknown;
                    "text/javascript": unknown;
                    "text/css": unknown;
                };
            };
            304: components["responses"]["NotModified"];
            404: components["responses"]["NotFound"];
        };
    };
}
